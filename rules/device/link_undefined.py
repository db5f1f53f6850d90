"""No udev rule creates a link that is used.

## What it finds
A path that a unit, a `.device` dependency, or an environment, compose, launch or parameter file uses, in a folder
where the tree's udev rules create links (such as /dev/robot/), when no rule creates it. In a tree without any
rules, paths in such folders are info. Directly in /dev: what a compose service hands to its container, where the rules
create another link that it hands over and the name is none of the kernel; and, as a warning, what a unit or a parameter
file names, where the rules create another such link that such a file names.

## Why it matters on a robot
The driver waits for a device that never appears, or exits with 'no such file'. A unit that depends on the device
unit times out after 90 s. Docker does not start a container one of whose devices is missing.

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

## When to ignore it
When a package that is not in the tree, for example the driver of the vendor, installs the rule.

## References
- udev(7), SYMLINK
- systemd.device(5)
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Related
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import note
from bringup_lint.api import rule
from bringup_lint.api.host import DeviceUse
from bringup_lint.api.udev import Link


@rule(
    "error",
    symptoms=[
        "Timed out waiting for device",
        "could not open port /dev/*: [Errno 2] No such file or directory",
        "No such file or directory: '/dev/",
        'error gathering device information while adding custom device "/dev/*": no such file or directory',
        "Serial port not found. | device: /dev/*, error 2, waiting for connection",
        "/dev/*No such file or directory",
    ],
)
def link_undefined(robot: Robot) -> Iterator[Finding]:
    for use, near in robot.devices.undefined:
        yield finding(
            use.path,
            f"No udev rule creates {use.path}: the device never appears",
            advice=f"did you mean {near.path}?" if near else "add a rule that creates the link, or correct the name",
            related=[
                *_made(robot, use, near),
                *(note(each, "opened here") for each in [use.opened_elsewhere] if each is not None),
                *_same(robot, use),
            ],
            chain=robot.provenance.chain_to(use.path, f"{use.path} is opened"),
        )
    for use, made in robot.devices.not_handed:
        yield finding(
            use.path,
            f"No udev rule creates {use.path}: docker does not start the container without it",
            advice="add a rule that creates the link, or correct the name",
            confidence="medium",
            related=[note(made.name, f"creates {made.path}, which {use.user} gets, too")],
        )
    for (first, *others), made in robot.devices.unmade:
        yield finding(
            first.path,
            f"No udev rule creates {first.path}: what opens it finds no device",
            advice="add a rule that creates the link, or correct the name",
            severity="warning",
            confidence="medium",
            related=[
                note(made.name, f"the rules of the tree create {made.path}"),
                *(note(each.path, "also used here" if each.path == first.path else "nor this") for each in others),
            ],
        )
    for use in robot.devices.without_rules:
        yield finding(
            use.path,
            f"No udev rule in this tree creates {use.path}",
            advice="add the rules file to this tree",
            severity="info",
        )


def _made(robot: Robot, use: DeviceUse, near: Link | None) -> list[Related]:
    if near:
        return [note(near.name, f"creates {near.path}")]
    folder = use.path.rpartition("/")[0]
    links = [link for link in robot.udev.links if link.is_fixed and link.path.rpartition("/")[0] == folder]
    return [note(link.name, f"a rule for {folder} is here") for link in links[:1]]


def _same(robot: Robot, use: DeviceUse) -> list[Related]:
    """The other places that name the same path."""
    others = [each.path for each in robot.devices.uses if each.path == use.path and each.path is not use.path]
    return [note(path, "also used here") for path in others[:3]]
