"""Two rules give the same link to devices that can be connected together.

## What it finds
One link name in two rules whose matches do not exclude each other. Rules for different vendors, products,
serial numbers or ports are alternatives and are not reported; rules for two indexes of the same camera are a warning,
and an info where one is above 3, which few cameras have. It is a warning where one rule is for a port on the board
(`ttyTHS1`) and the other for a USB device, of which a robot may have the one or the other.
Rules that a `GOTO` separates, or with `link_priority`, are not reported.

## Why it matters on a robot
Which device gets the link depends on the order in which they are found: after a reboot the driver talks to
the other one.

## Bad
```udev
SUBSYSTEM=="tty", ATTRS{serial}=="A5XK3RJT", SYMLINK+="robot/imu"
SUBSYSTEM=="tty", KERNELS=="1-1.2", SYMLINK+="robot/imu"
```

## Good
```udev
SUBSYSTEM=="tty", ATTRS{serial}=="A5XK3RJT", SYMLINK+="robot/imu"
SUBSYSTEM=="tty", ATTRS{serial}=="FTHK9L2M", SYMLINK+="robot/base"
```

## When to ignore it
If the two rules describe alternative hardware, of which a robot never carries both, and the rules cannot
express that.

## References
- udev(7), SYMLINK and OPTIONS "link_priority="
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import note
from bringup_lint.api import regex
from bringup_lint.api import rule
from bringup_lint.api.udev import Link

ON_BOARD = regex(r"tty(?:THS|AMA|SC?|mxc|LP|PS|O)\d{1,3}", hints="tty")
USUAL = ("0", "1", "2", "3")


@rule("error", symptoms=["appeared twice with different sysfs paths"])
def duplicate_symlink(robot: Robot) -> Iterator[Finding]:
    for rules in robot.udev.sets:
        seen = set()
        for first, second in rules.same_links:
            if second.rule.judged and second not in seen:
                seen.add(second)
                beside = _are_board_and_usb(first, second) or _are_board_and_usb(second, first)
                both = ": with the USB device beside that on the board," if beside else " and can match two devices:"
                yield finding(
                    second.name,
                    f"Two rules make {second.path}{both} the order of discovery decides which one",
                    advice='tell the devices apart, or give one rule OPTIONS+="link_priority="',
                    related=[note(first.name, "the other rule")],
                    severity="warning" if beside else None,
                )
        for first, second in rules.same_camera_links:
            if second.rule.judged and second not in seen:
                seen.add(second)
                yield finding(
                    second.name,
                    f"Two nodes of one camera take {second.path}: the order of discovery decides which one has it",
                    advice="leave out the rule for the node without images",
                    related=[note(first.name, "the other node")],
                    severity="warning" if _are_usual(first, second) else "info",
                    confidence="medium",
                )


def _are_board_and_usb(one: Link, other: Link) -> bool:
    names = [name for each in one.rule.on("KERNEL") for name in each.patterns]
    return any(map(ON_BOARD.fullmatch, names)) and bool(other.rule.usb_ids)


def _are_usual(*links: Link) -> bool:
    """Whether the rules are for nodes that a camera may well have: two streams, each with a node for its data."""
    return all(text in USUAL for link in links for each in link.rule.on("ATTR", "index") for text in each.patterns)
