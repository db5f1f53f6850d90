"""Security is enabled, but permissive.

## What it finds
A process with ROS_SECURITY_ENABLE=true and ROS_SECURITY_STRATEGY=Permissive, or without a strategy, which means the
same, and a script that exports both for whoever sources it. Files for tests and development are not reported, nor a
script beside another one for Enforce: the user has the choice.

## Why it matters on a robot
A node whose credentials are not found runs unsecured and can still join: the robot works, but is open.

## Bad
```sh
ROS_SECURITY_ENABLE=true
ROS_SECURITY_STRATEGY=Permissive
```

## Good
```sh
ROS_SECURITY_ENABLE=true
ROS_SECURITY_STRATEGY=Enforce
```

## When to ignore it
During the migration of a robot to SROS2, as long as the network is trusted.

## References
- rcl, `security.c`: the values are compared letter by letter
- https://docs.ros.org/en/rolling/Tutorials/Advanced/Security/The-Keystore.html
"""

import os
from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import Span
from bringup_lint.api import finding
from bringup_lint.api import fix
from bringup_lint.api import note
from bringup_lint.api import rule


@rule("warning", fix="unsafe", symptoms=["SECURITY ERROR: directory '*' does not exist., at"], tags=["CWE-1188"])
def ros_security_permissive(robot: Robot) -> Iterator[Finding]:
    seen: set[Span] = set()
    yield from of_processes(robot, seen)
    yield from of_scripts(robot, seen)


def of_processes(robot: Robot, seen: set[Span]) -> Iterator[Finding]:
    """The processes that are permissive; ``seen`` takes the values that made them so."""
    for process in robot.ros.processes:
        environment = process.environment
        enable, strategy = environment.get("ROS_SECURITY_ENABLE"), environment.get("ROS_SECURITY_STRATEGY")
        if enable is None or enable.text != "true" or robot.ros.is_development(enable.value):
            continue
        if strategy is not None and strategy.text == "Permissive":
            seen.add(strategy.value.span)
            yield finding(
                strategy.value,
                f"{process.name} is permissive: nodes without credentials still join",
                advice="write Enforce",
                related=[note(process.where, f"{process.name} gets the variable")],
                fix=fix("write Enforce", (strategy.value, "Enforce"), safe=False),
            )
        elif strategy is None and environment.complete:
            yield finding(
                enable.value,
                f"{process.name} has no ROS_SECURITY_STRATEGY, which means permissive: nodes without credentials "
                "still join",
                advice="add ROS_SECURITY_STRATEGY=Enforce",
                related=[note(process.where, f"{process.name} gets the variable")],
            )


def of_scripts(robot: Robot, seen: set[Span]) -> Iterator[Finding]:
    """The scripts that make permissive whoever sources them, where no script beside them is strict."""
    enabled = {each.value.span.source: each for each in robot.ros.of("ROS_SECURITY_ENABLE") if each.text == "true"}
    strategies = list(robot.ros.of("ROS_SECURITY_STRATEGY"))
    strict = {os.path.dirname(each.value.span.path) for each in strategies if each.text == "Enforce"}
    for each in strategies:
        switch = enabled.get(each.value.span.source)
        if each.origin != "export" or each.text != "Permissive" or switch is None or each.value.span in seen:
            continue
        if os.path.dirname(each.value.span.path) in strict:
            continue
        if not robot.ros.is_development(each.value):
            yield finding(
                each.value,
                "Whoever sources this script is permissive: nodes without credentials still join",
                advice="write Enforce",
                related=[note(switch.value, "security is switched on here")],
                fix=fix("write Enforce", (each.value, "Enforce"), safe=False),
            )
