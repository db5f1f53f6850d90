"""twist_mux does not let the operator, or the emergency stop, through.

## What it finds
In parameter files of twist_mux that something names: inputs of navigation with a higher priority than every input of
a person (joystick, teleoperation, keyboard); locks for an emergency stop with a priority that is not above that of an
input, and other locks that stop the robot with one that is not above that of an input that no person sends; a `timeout`
of 0 for an input that is not the lowest; and inputs with priority 0.

## Why it matters on a robot
twist_mux forwards only the input with the highest priority that is not too old. With navigation on top, the joystick
has no effect as long as navigation drives, and that is when it is needed. A lock holds back what has a lower
priority than itself, and nothing else. An input that never gets too old holds back all others after its first message,
also when its program is long gone. Priority 0 is never selected.

## Bad
```yaml
twist_mux:
  ros__parameters:
    topics:
      navigation: {topic: cmd_vel_nav, timeout: 0.5, priority: 100}
      joystick: {topic: cmd_vel_joy, timeout: 0.5, priority: 10}
```

## Good
```yaml
twist_mux:
  ros__parameters:
    topics:
      navigation: {topic: cmd_vel_nav, timeout: 0.5, priority: 10}
      joystick: {topic: cmd_vel_joy, timeout: 0.5, priority: 100}
```

## When to ignore it
When a switch of the hardware gives the robot to the operator.

## References
- twist_mux, twist_mux.cpp (`hasPriority`) and topic_handle.hpp (`isMasked`, `hasExpired`)
- https://github.com/ros-teleop/twist_mux
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import note
from bringup_lint.api import rule
from bringup_lint.api.params import operator_problems

_TEXTS = {
    "order": (
        "{other} has priority over {name} ({detail}): the operator cannot take over",
        "give {name} the higher priority",
    ),
    "lock": (
        "The lock {name} does not hold back {other} ({detail}): the robot drives on",
        "give the lock a priority above all inputs, such as 255",
    ),
    "endless": (
        "{name} never gets too old: after its first message, {other} has no effect any more",
        "set a timeout of a few periods of the input, such as 0.5",
    ),
    "never": ("{name} has priority 0: twist_mux never forwards it", "give it a priority from 1 to 255"),
}
"""Kind -> what happens, and what to write instead."""


@rule("warning", silent="twist_mux drops the message of an input that is masked without a word")
def operator_overridden(robot: Robot) -> Iterator[Finding]:
    for each in operator_problems(robot.params):
        if each.kind in _TEXTS:
            said = {"name": each.name, "other": each.other, "detail": each.detail}
            message, advice = (text.format(**said) for text in _TEXTS[each.kind])
            yield finding(
                each.where,
                message,
                advice=advice,
                related=[note(each.related, f"the priority of {each.other}")] if each.related is not None else [],
            )
