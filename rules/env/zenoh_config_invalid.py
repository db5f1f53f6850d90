"""zenoh rejects its configuration.

## What it finds
For processes that may run rmw_zenoh_cpp: a `ZENOH_ROUTER_CONFIG_URI` or `ZENOH_SESSION_CONFIG_URI` whose file does
not exist (in a root file system) or is not JSON5, and a part of `ZENOH_CONFIG_OVERRIDE` without `=`.

## Why it matters on a robot
No session is opened and no node starts. The log only says that the logging system is not initialised.

## Bad
```sh
ZENOH_CONFIG_OVERRIDE=mode:"client";connect/endpoints=["tcp/10.0.0.20:7447"]
```

## Good
```sh
ZENOH_CONFIG_OVERRIDE=mode="client";connect/endpoints=["tcp/10.0.0.20:7447"]
```

## When to ignore it
When a script or unit generates the file before the nodes start.

## References
- rmw_zenoh, README: configuration
- https://github.com/ZettaScaleLabs/roscon2024_workshop/issues/12
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import Span
from bringup_lint.api import finding
from bringup_lint.api import note
from bringup_lint.api import rule
from bringup_lint.api.environment import RosProcess
from bringup_lint.api.ros import json5
from bringup_lint.api.systemd import Variable

FILES = ("ZENOH_ROUTER_CONFIG_URI", "ZENOH_SESSION_CONFIG_URI")


@rule(
    "error",
    symptoms=[
        "Error configuring Zenoh session",
        "logging system not initialized",
        "Failed to read config from",
    ],
)
def zenoh_config_invalid(robot: Robot) -> Iterator[Finding]:
    if not robot.may_hold("ZENOH_"):
        return
    read: dict[Span, tuple[Variable, RosProcess]] = {}
    for process in robot.ros.processes:
        if process.environment.text("RMW_IMPLEMENTATION") not in (None, "rmw_zenoh_cpp"):
            continue
        if process.unit:
            for name in FILES:
                variable = process.environment.get(name)
                if variable is not None and variable.text and variable.text.startswith("/"):
                    read.setdefault(variable.value.span, (variable, process))
        variable = process.environment.get("ZENOH_CONFIG_OVERRIDE")
        if variable is not None and variable.text and variable.value == variable.text:
            read.setdefault(variable.value.span, (variable, process))
    for variable, process in read.values():
        check = _file if variable.name in FILES else _override
        yield from check(robot, variable, process)


def _file(robot: Robot, variable: Variable, process: RosProcess) -> Iterator[Finding]:
    path = variable.text or ""
    source = robot.tree.find(path)
    if source is None and robot.tree.has(path) is False:
        yield finding(
            variable.value,
            f"{variable.text} does not exist: zenoh opens no session, and {process.name} starts no node",
            advice="install the file, or delete the variable to get the default configuration",
            related=[note(process.where, f"{process.name} gets the variable")],
        )
    problem = json5.fault(source) if source is not None and not source.template else None
    if problem is not None:
        yield finding(
            problem.where,
            f"The file is not JSON5 ({problem.detail}): zenoh opens no session, and {process.name} starts no node",
            advice="start from the default file of the installed rmw_zenoh_cpp",
            related=[note(variable.value, f"{process.name} reads it through this variable")],
        )


def _override(robot: Robot, variable: Variable, process: RosProcess) -> Iterator[Finding]:
    value = variable.value
    if any(bracket in value for bracket in ("{", "%")):
        return
    at = 0
    for part in value.split(";"):
        text = value.part(at, at + len(part)).strip_located()
        at += len(part) + 1
        if text and "=" not in text:
            yield finding(
                text,
                f"'{text}' is not key=value: zenoh opens no session, and {process.name} starts no node",
                advice="write pairs such as mode=\"client\", separated by ';'",
                related=[note(process.where, f"{process.name} gets the variable")],
            )
