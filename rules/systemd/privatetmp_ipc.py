"""PrivateTmp= separates a shared-memory daemon from its clients.

## What it finds
PrivateTmp=yes on a service that runs RouDi, or whose Cyclone DDS configuration enables iceoryx shared memory.
Their sockets and locks are in /tmp. Fast DDS is not affected, because its segments are in /dev/shm.

## Why it matters on a robot
RouDi and its clients use different /tmp folders. Every node waits for RouDi in vain.

## Bad
```ini
[Service]
ExecStart=/opt/ros/jazzy/bin/iox-roudi
PrivateTmp=yes
```

## Good
```ini
[Service]
ExecStart=/opt/ros/jazzy/bin/iox-roudi
PrivateTmp=no
```
or JoinsNamespaceOf= in all services that use it.

## When to ignore it
When RouDi and all its clients run in this one service.

## References
- systemd.exec(5), PrivateTmp=; systemd.unit(5), JoinsNamespaceOf=
"""

import re
from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Located
from bringup_lint.api import Robot
from bringup_lint.api import Span
from bringup_lint.api import finding
from bringup_lint.api import note
from bringup_lint.api import regex
from bringup_lint.api import rule
from bringup_lint.api.systemd import Unit

SHARED = regex(r"<SharedMemory\b[^>]*>(?:(?!</SharedMemory>).)*?<Enable>\s*true\s*</Enable>", re.S | re.I)


@rule("warning", symptoms=["Timeout registering at RouDi", "RouDi not found"])
def privatetmp_ipc(robot: Robot) -> Iterator[Finding]:
    for unit in robot.units.services:
        private = unit.flag("PrivateTmp")
        if not private or unit.has("JoinsNamespaceOf") or robot.units.supervision(unit).in_container:
            continue
        for where, what in _uses(unit, robot):
            yield finding(
                private.where,
                f"PrivateTmp= gives {unit.name} its own /tmp: {what} cannot reach the other services there",
                advice="set PrivateTmp=no, or join the services with JoinsNamespaceOf=",
                related=[note(where, what)],
            )
            break


def _uses(unit: Unit, robot: Robot) -> Iterator[tuple[Located | Span, str]]:
    for process in robot.units.started(unit):
        for step in process.steps:
            for word in step.command.words:
                if word.rpartition("/")[2] == "iox-roudi":
                    yield word, "RouDi"
    variable = robot.units.environment(unit).get("CYCLONEDDS_URI")
    if variable is not None and variable.text and variable.text.startswith("file://"):
        source = robot.tree.find(variable.text.removeprefix("file://"))
        found = SHARED.search(source.said) if source else None
        if source and found:
            yield (
                source.located(found.start(), found.start() + len("<SharedMemory")),
                "Cyclone DDS with shared memory",
            )
