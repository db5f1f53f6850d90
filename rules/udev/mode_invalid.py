"""MODE is not an octal number.

## What it finds
A `MODE` that is not an octal number up to 7777, such as `rw-rw----` or `0888`.

## Why it matters on a robot
udev accepts the line, then fails to parse the mode when the device appears: the device node keeps its
previous mode, and the driver gets 'permission denied'. `udevadm verify` finds nothing wrong.

## Bad
```udev
KERNEL=="ttyACM*", MODE="rw-rw----"
```

## Good
```udev
KERNEL=="ttyACM*", MODE="0660"
```

## When to ignore it
Never: udev ignores the mode, so the line does not set the permissions that it shows.

## References
- udev(7), MODE
"""

import re
from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import rule


@rule("error", symptoms=["Failed to parse mode"])
def mode_invalid(robot: Robot) -> Iterator[Finding]:
    for line in robot.udev.judged:
        for token in line.line.assignments("MODE"):
            if token.value and not token.has_substitution and not _is_mode(token.value):
                yield finding(
                    token.value,
                    f"'{token.value}' is not an octal mode: udev cannot parse it and does not set the mode",
                    advice="write octal digits, such as 0660",
                )


def _is_mode(value: str) -> bool:
    return bool(re.fullmatch(r"[0-7]+", value)) and int(value, 8) <= 0o7777
