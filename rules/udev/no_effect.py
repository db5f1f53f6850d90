r"""A rule matches but does nothing.

## What it finds
A line with matches only: no assignment, no jump, no label, no program. A line with `SYMLINK==` is reported by
udev/symlink-match. Also a jump to the very next line, which skips nothing; it is info where each line after the label
names its device itself.

## Why it matters on a robot
udev drops the line. Usually an assignment was lost, or a backslash is missing at the end of the line and the
next line has become a rule of its own that fires for every device. A jump that skips nothing was to limit the lines
after it to one device: they are read for every other one as well.

## Bad
```udev
SUBSYSTEM=="tty", ATTRS{serial}=="A5XK3RJT",
  SYMLINK+="robot/imu"
```

## Good
```udev
SUBSYSTEM=="tty", ATTRS{serial}=="A5XK3RJT", \
  SYMLINK+="robot/imu"
```

## When to ignore it
If the line is a placeholder and you accept the message that udev logs each time it loads the rules.

## References
- udev(7), "Rules Files"
- `udevadm verify`: The line has no effect
"""

from collections.abc import Iterator
from itertools import pairwise

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import note
from bringup_lint.api import rule
from bringup_lint.api.udev import Rule
from bringup_lint.api.udev import RulesFile

_OF_CLASS = frozenset({"ACTION", "KERNEL", "SUBSYSTEM", "SUBSYSTEMS", "DRIVERS"})
"""Keys that hold for a whole class of devices."""


@rule("warning", symptoms=["The line has no effect, ignoring"])
def no_effect(robot: Robot) -> Iterator[Finding]:
    for problem, line in robot.udev.problems("no-effect"):
        if not line.matches("SYMLINK"):
            yield finding(
                problem.where,
                "The line assigns nothing: udev drops it",
                advice="add the assignment, or end the line with a backslash if the next one belongs to it",
            )
    for file in robot.udev.files:
        yield from _jumps(file) if file.source.judged else ()


def _jumps(file: RulesFile) -> Iterator[Finding]:
    """Lines that only jump, and only to the next line."""
    for index, (line, following) in enumerate(pairwise(file.rules)):
        goto, label = line.assignments("GOTO"), following.assignments("LABEL")
        if len(goto) != 1 or not label or goto[0].value != label[0].value:
            continue
        if all(token.is_match or token is goto[0] for token in line.tokens):
            yield finding(
                goto[0].value,
                "The jump leads to the next line and skips nothing: what follows the label is read for every device",
                advice="jump over the lines where the device is another one: ATTRS{...}!=..., GOTO=...",
                related=[note(label[0].value, "the label")],
                severity="info" if all(map(_names_device, file.rules[index + 2 :])) else None,
            )


def _names_device(line: Rule) -> bool:
    """Whether a line matches less than a whole class of devices, or sets nothing."""
    own = {token.key for token in line.tokens if token.is_match}
    return not own <= _OF_CLASS or all(token.is_match or token.key in ("GOTO", "LABEL") for token in line.tokens)
