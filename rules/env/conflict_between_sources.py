"""Processes of one robot use different domains or middlewares.

## What it finds
ROS_DOMAIN_ID or RMW_IMPLEMENTATION with different values in units that start together, in services of one compose
file, or in nodes of their launch files. Units and the services of a compose file belong together if there is one such
group and one file, and docker starts the services at boot on the network of the host. Also a launch file that overrides
the value that the unit or service gets from another file. Not reported: unknown values, a launch file that gives its
own nodes several values, and processes that bridge domains.

## Why it matters on a robot
The processes do not see each other. Each part works on its own, and the topics of the other part are silently
missing.

## Bad
```sh
# drivers.service
Environment=ROS_DOMAIN_ID=42
# navigation.service
Environment=ROS_DOMAIN_ID=0
```

## Good
```sh
# both units
EnvironmentFile=/etc/robot/ros.env
```

## When to ignore it
When the parts are separated on purpose and a bridge that the linter does not recognise connects them.

## References
- https://github.com/hucebot/g1pilot/issues/30
- https://github.com/ros2/ros2cli/issues/1009
"""

import re
from collections.abc import Iterable
from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import note
from bringup_lint.api import regex
from bringup_lint.api import rule
from bringup_lint.api.environment import RosProcess
from bringup_lint.api.systemd import Unit
from bringup_lint.api.systemd import Variable

_OF_SHELL = ("export", "shell", "declare", "typeset", "readonly")
BRIDGE = regex(r"(?<!ros)(?<!ros[-_])bridge|domain", re.I)
"""Names of what may join two domains; rosbridge only talks to browsers."""


@rule(
    "warning",
    symptoms=["no topics", "nodes do not see each other"],
    aliases=["env/set-twice-mismatch", "env/rmw-inconsistent-across-units"],
)
def conflict_between_sources(robot: Robot) -> Iterator[Finding]:
    for name in ("ROS_DOMAIN_ID", "RMW_IMPLEMENTATION"):
        for group in _together(robot):
            found = [(process, variable) for process in group if (variable := _known(process, name))]
            values: dict[str | None, list] = {}
            for process, variable in found:
                values.setdefault(variable.text, []).append((process, variable))
            yield from _overruled_by_script(name, found)
            if len(values) < 2:
                yield from _overruled(name, found)
                continue
            usual = max(values.values(), key=len)
            for text, users in values.items():
                if users is usual:
                    continue
                process, variable = users[0]
                other, common = usual[0]
                if process.launched and variable.value.span.source is common.value.span.source:
                    continue
                yield finding(
                    variable.value,
                    f"{process.name} has {name}={text}, but {other.name} has {name}={common.text}: "
                    "they do not see each other",
                    advice="keep the variable in one environment file that all of them read",
                    related=[note(common.value, f"{other.name} gets its value here")],
                )


def _overruled(name: str, found: Iterable[tuple[RosProcess, Variable]]) -> Iterator[Finding]:
    """Launch files that give a whole robot another value than its unit or service says."""
    seen = set()
    for process, variable in found:
        before = [each for each in process.environment.chain(name) if each.text and each.text != variable.text]
        place = (id(variable.value.span.source), variable.value.span.start)
        if process.launcher is None or not before or place in seen:
            continue
        if before[-1].value.span.source is not variable.value.span.source:
            seen.add(place)
            holder = process.launcher.name
            yield finding(
                variable.value,
                f"{process.name} has {name}={variable.text}: launch overrides the {before[-1].text} of {holder}",
                advice="keep the variable in one environment file, and do not set it in the launch file",
                related=[note(before[-1].value, f"{holder} gets this value")],
            )


def _overruled_by_script(name: str, found: Iterable[tuple[RosProcess, Variable]]) -> Iterator[Finding]:
    """Scripts that set another value than the unit that starts them."""
    seen = set()
    for process, variable in found:
        unit = process.unit
        if unit is None or process.launcher is not None or variable.origin not in _OF_SHELL or variable in seen:
            continue
        before = [each for each in process.environment.chain(name) if each.origin not in _OF_SHELL and each.text]
        if before and before[-1].text != variable.text:
            seen.add(variable)
            yield finding(
                variable.value,
                f"{process.name} has {name}={variable.text}: the shell overrides the {before[-1].text} of the unit",
                advice="keep the variable in one place, and do not set it in the script",
                related=[note(before[-1].value, "the unit sets this value")],
            )


def _known(process: RosProcess, name: str) -> Variable | None:
    variable = process.environment.get(name)
    if variable is None or not variable.text or BRIDGE.search(process.name):
        return None
    return variable


def _together(robot: Robot) -> Iterable[list[RosProcess]]:
    """Processes that certainly belong to one robot: units that do, services of one compose file, their nodes."""
    groups: dict[object, list[RosProcess]] = {}
    units = {id(process.unit): process.unit for process in robot.ros.processes if process.unit}
    crews = robot.units.same_robot_groups(units.values()) if units else []
    crew_of = {id(unit): number for number, crew in enumerate(crews) for unit in crew}
    for process in robot.ros.processes:
        by_hand = process.launched and process.launcher is None
        if by_hand or (process.launched and robot.ros.is_development(process.where)):
            continue
        key = crew_of[id(process.unit)] if process.unit else (process.launcher or process).source.name
        if len(crews) == 1 and _comes_up_beside(robot, process, crews[0]):
            key = 0
        groups.setdefault(key, []).append(process)
    return groups.values()


def _comes_up_beside(robot: Robot, process: RosProcess, crew: Iterable[Unit]) -> bool:
    """Whether a service of the only compose file runs on the network of the robot whose only units these are: docker
    starts it at boot, as systemd starts them."""
    service = process.service
    if service is None or not service.is_on_host_network or len(robot.compose.files) != 1:
        return False
    boots = service.restart in ("always", "unless-stopped")
    return boots and all(robot.same_robot(service.source, unit.where.source) for unit in crew)
