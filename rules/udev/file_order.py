"""A rules file sorts before the packaged file that it needs.

## What it finds
Two mistakes in the order of files, which udev reads in the order of their names, whatever folder they are in:
- A match on a property such as `ENV{ID_PATH}` or `ENV{ID_SERIAL_SHORT}` in a file that is read before the
  packaged file that imports the property.
- `GROUP` or `MODE` in a file that is read before the packaged file that sets it to another value. It is an info where
  the group that the rule sets may read and write all the same.

## Why it matters on a robot
In the first case the property is still empty, so the rule never fires. In the second case the packaged file
overwrites the permission, so the driver gets 'permission denied'.

## Bad
```udev
# 10-robot.rules
SUBSYSTEM=="tty", ENV{ID_PATH}=="pci-*-usb-0:1.2:1.0", SYMLINK+="robot/imu"
```

## Good
```udev
# 99-robot.rules
SUBSYSTEM=="tty", ENV{ID_PATH}=="pci-*-usb-0:1.2:1.0", SYMLINK+="robot/imu"
```

## When to ignore it
If the packaged file is masked or removed on the robot, or a rule that the linter does not see imports the
property earlier.

## References
- udev(7), "Rules Files"
- https://github.com/odriverobotics/ODrive/issues/241
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import note
from bringup_lint.api import rule
from bringup_lint.api.udev import TooEarly
from bringup_lint.api.udev import UdevRule

_MOST_SHOWN = 20


@rule("warning", silent="a match that fails is not reported")
def file_order(robot: Robot) -> Iterator[Finding]:
    causes: dict[tuple[str, str], list[tuple[UdevRule, TooEarly]]] = {}
    for line, early in robot.udev.too_early:
        causes.setdefault((early.token.span.path, _message(line, early)), []).append((line, early))
    for (_, message), found in causes.items():
        (line, early), *others = found
        yield finding(
            early.token.span,
            message + (f" ({len(found)} lines)" if others else ""),
            advice=f"rename the file so that it sorts after {early.file}, such as 99-robot.rules",
            related=[note(other.token.span, "this line too") for _, other in others[:_MOST_SHOWN]],
            confidence="medium" if line.is_for_usb_nodes else None,
            severity="info" if all(_has_its_group(*each) for each in found) else None,
        )


def _has_its_group(line: UdevRule, early: TooEarly) -> bool:
    """Whether the group that the rule names may read and write all the same."""
    return early.token.key == "MODE" and str(early.value) in ("0660", "0664") and bool(line.line.assignments("GROUP"))


def _message(line: UdevRule, early: TooEarly) -> str:
    name = line.source.basename
    if not early.value:
        return f"{early.token.attribute} is empty in {name}, {early.file} sets it later: the rule never fires"
    whose = " of the USB device node" * line.is_for_usb_nodes
    return f"{early.file} is read after {name} and overwrites {early.token.key}{whose} with {early.value}"
