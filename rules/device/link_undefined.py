"""A link below /dev is used that no udev rule makes.

## What it finds
A path in a folder where the tree's rules make links (such as /dev/robot/), used in a unit, a `.device` dependency, an
environment, compose, launch or parameter file, that none of them makes. In a tree without any rule, paths in folders
of one's own are told for information.

## Why it matters on a robot
The driver waits for a device that never appears, or ends with 'no such file'. A unit that depends on the
device unit times out after 90 s.

## Bad
```ini
# the rule says SYMLINK+="robot/lidar_front"
Environment=LIDAR=/dev/robot/lidar-front
```

## Good
```ini
# the rule says SYMLINK+="robot/lidar_front"
Environment=LIDAR=/dev/robot/lidar_front
```

## References
- udev(7), SYMLINK
- systemd.device(5)
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import note
from bringup_lint.api import rule


@rule("error", symptoms=["Timed out waiting for device", "No such file or directory: '/dev/"])
def link_undefined(robot: Robot) -> Iterator[Finding]:
    for use, near in robot.devices.undefined:
        yield finding(
            use.path,
            f"No udev rule makes {use.path}: the device never appears",
            advice=f"did you mean {near.path}?" if near else "add a rule that makes the link, or correct the name",
            related=[*_made(robot, use, near), *_same(robot, use)],
            chain=robot.provenance.chain_to(use.path, f"{use.path} is opened"),
        )
    for use in robot.devices.without_rules:
        yield finding(
            use.path,
            f"No udev rule in this tree makes {use.path}",
            advice="ship the rules file with the rest",
            severity="info",
        )


def _made(robot: Robot, use, near):
    if near:
        return [note(near.name, f"makes {near.path}")]
    folder = use.path.rpartition("/")[0]
    links = [link for link in robot.udev.links if link.is_fixed and link.path.rpartition("/")[0] == folder]
    return [note(link.name, f"a rule for {folder} is here") for link in links[:1]]


def _same(robot: Robot, use):
    """The other places that name the same path."""
    others = [each.path for each in robot.devices.uses if each.path == use.path and each.path is not use.path]
    return [note(path, "and it is named here") for path in others[:3]]
