"""ROS_DOMAIN_ID is read as a different number.

## What it finds
A value that rcl accepts but reads differently: a leading zero means octal, `0x` means hexadecimal, and everything
after the digits is ignored.

## Why it matters on a robot
The process joins another domain than the rest of the robot. No message says so: its topics are just missing.

## Bad
```sh
ROS_DOMAIN_ID=042
```

## Good
```sh
ROS_DOMAIN_ID=42
```

## When to ignore it
When all processes of the robot get exactly the same text, so that they all join the same domain.

## References
- rcl, `domain_id.c`: strtoul with base 0; the rest of the text counts only when the number is 0
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Fix
from bringup_lint.api import Located
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import fix
from bringup_lint.api import rule
from bringup_lint.api.ros import MAX_DOMAIN
from bringup_lint.api.ros import domain_id


@rule("error", fix="unsafe", symptoms=["no topics", "nodes do not see each other"])
def ros_domain_id_misparsed(robot: Robot) -> Iterator[Finding]:
    for setting in robot.ros.of("ROS_DOMAIN_ID"):
        number, plain = domain_id(setting.text)
        if number is not None and not plain:
            yield finding(
                setting.value,
                f"ROS_DOMAIN_ID '{setting.text}' is read as domain {number}",
                advice="write the number in plain decimal digits",
                fix=_as_read(setting.value, number) if number <= MAX_DOMAIN else None,
            )


def _as_read(value: Located, number: int) -> Fix:
    return fix(f"write {number}, as it is read now", (value, str(number)), safe=False)
