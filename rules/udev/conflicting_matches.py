"""Two matches of a rule exclude each other.

## What it finds
Two matches on one line that no device satisfies at once, or a match for devices that an earlier jump skips.

## Why it matters on a robot
The rule never fires, and udevd does not report it: no link, no permissions, and the driver waits for its
device.

## Bad
```udev
KERNEL=="ttyUSB*", KERNEL=="ttyACM*", SYMLINK+="robot/base"
```

## Good
```udev
KERNEL=="ttyUSB*|ttyACM*", SYMLINK+="robot/base"
```

## When to ignore it
Never: no device can satisfy both matches. To disable a rule on purpose, comment it out.

## References
- udev(7), "Rules Files"
- `udevadm verify`: conflicting match expressions
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import note
from bringup_lint.api import rule
from bringup_lint.api.udev import Condition


@rule("error", symptoms=["conflicting match expressions, the line has no effect"])
def conflicting_matches(robot: Robot) -> Iterator[Finding]:
    for line in robot.udev.judged:
        for first, second in line.contradictions:
            yield finding(
                second.token.span,
                f"No device has {first.text} and {second.text} at once: the rule never fires",
                advice=_advice(first, second),
                related=[note(first.token.span, _why(first))],
            )


def _why(condition: Condition) -> str:
    return f"only devices with {condition.text} get past this jump" if condition.inherited else "the other match"


def _advice(first: Condition, second: Condition) -> str:
    if not first.inherited and first.equal and second.equal:
        return f'write {second.token.name}=="{first.token.value}|{second.token.value}" for either of them'
    return "delete the match that is wrong"
