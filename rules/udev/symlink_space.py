"""A space splits a link name in two.

## What it finds
A space in a `SYMLINK` value that does not look like a separator. After a name comes a bare number, a single
character, or a word without a folder although the first name has one. It is info where no file of the tree names one
of the two links, nor the one that was meant.

## Why it matters on a robot
`robot/front camera` makes the links /dev/robot/front and /dev/camera. A driver that opens the whole name
finds nothing.

## Bad
```udev
SUBSYSTEM=="video4linux", ATTRS{serial}=="C1", ATTR{index}=="0", SYMLINK+="robot/front camera"
```

## Good
```udev
SUBSYSTEM=="video4linux", ATTRS{serial}=="C1", ATTR{index}=="0", SYMLINK+="robot/front_camera"
```

## When to ignore it
If the line is meant to make both links.

## References
- udev(7), SYMLINK and OPTIONS "string_escape="
- https://github.com/orbbec/OrbbecSDK_ROS2/issues/137
"""

from collections.abc import Iterator
from itertools import pairwise

from bringup_lint.api import Finding
from bringup_lint.api import Located
from bringup_lint.api import NamedTuple
from bringup_lint.api import Robot
from bringup_lint.api import Source
from bringup_lint.api import finding
from bringup_lint.api import note
from bringup_lint.api import rule


class Torn(NamedTuple):
    """Two links that were meant as one."""

    first: Located
    second: Located


@rule("warning", silent="udev makes both links without a message")
def symlink_space(robot: Robot) -> Iterator[Finding]:
    files: dict[Source, list[Torn]] = {}
    for line in robot.udev.judged:
        names = [link.name for link in line.links]
        for first, second in pairwise(names):
            if first.span.end < second.span.start <= first.span.end + 2 and _is_torn(first, second):
                files.setdefault(line.source, []).append(Torn(first, second))
    for source, found in files.items():
        (first, second), *others = found
        more = f" ({len(others) + 1} such names in this file)" if others else ""
        yield finding(
            source.span(first.span.start, second.span.end),
            f"The space makes two links, /dev/{first.removeprefix('/dev/')} and /dev/{second}{more}",
            advice=f"write {first}_{second} for one link",
            related=[note(other.first, "two links here, too") for other in others[:20]],
            severity=None if any(_is_opened(robot, each) for each in found) else "info",
        )


def _is_opened(robot: Robot, torn: Torn) -> bool:
    first = torn.first.removeprefix("/dev/")
    names = (first, torn.second, f"{first}_{torn.second}")
    return any(robot.devices.names(f"/dev/{name}") for name in names)


def _is_torn(first: str, second: str) -> bool:
    """Whether the second word can hardly be a link of its own."""
    if second.isdecimal() or len(second) == 1:
        return True
    folder, _, last = first.rpartition("/")
    return bool(folder) and "/" not in second and last not in second and second not in last
