r"""A link depends only on the vendor and product id.

## What it finds
A rule for a serial port or camera that makes a link and identifies the device by `idVendor` and `idProduct`
alone:
- **warning**: a robot with a second device of these ids, for which another rule makes another link; and any device
  whose link ends in the number of the kernel (`gps_%n`).
- **info**: any other device, and one that compose hands to a container under the name of the other link: both names are
  for it.

## Why it matters on a robot
A second adapter with the same chip also matches and takes the link: IMU and motor controller can swap from
one boot to the next.

## Bad
```udev
SUBSYSTEM=="tty", ATTRS{idVendor}=="0403", ATTRS{idProduct}=="6001", SYMLINK+="robot/imu"
```

## Good
```udev
SUBSYSTEM=="tty", ATTRS{idVendor}=="0403", ATTRS{idProduct}=="6001", ATTRS{serial}=="A5XK3RJT", \
  SYMLINK+="robot/imu"
```

## When to ignore it
If the robot carries exactly one device with this id, nobody plugs in another, and the link must also work for
a replacement device with a different serial number.

## References
- udev(7), ATTRS and KERNELS
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import note
from bringup_lint.api import regex
from bringup_lint.api import rule
from bringup_lint.api.udev import Link

_WEAK = {
    ("SUBSYSTEM", ""),
    ("SUBSYSTEMS", ""),
    ("ACTION", ""),
    ("KERNEL", ""),
    ("DRIVERS", ""),
    ("ATTRS", "idVendor"),
    ("ATTRS", "idProduct"),
    ("ATTR", "index"),
    ("ENV", "ID_V4L_CAPABILITIES"),
    ("ENV", "MAJOR"),
    ("ENV", "DEVTYPE"),
    ("ENV", "ID_BUS"),
}
NUMBERED = regex(r"(?:%n|\$number)$")
_MOST_RIVALS = 50
_DECIDING = ("PROGRAM", "IMPORT", "RESULT", "TEST")


@rule("warning", symptoms=["appeared twice with different sysfs paths"])
def symlink_vidpid_only(robot: Robot) -> Iterator[Finding]:
    of_id: dict[str, list[Link]] = {}
    for link in robot.udev.links:
        for usb_id in link.rule.usb_ids:
            of_id.setdefault(usb_id, []).append(link)
    for line in robot.udev.matching:
        if not line.usb_ids or not (line.is_serial or line.is_for("video4linux")):
            continue
        if not line.subjects <= _WEAK or any(line.line.first(key) for key in _DECIDING):
            continue
        for link in line.links:
            if NUMBERED.search(link.name):
                yield finding(
                    link.name,
                    f"The number in {link.name} is that of the kernel, which counts devices in the order of discovery",
                    advice="match ATTRS{serial}, or the USB port, and give the link a fixed name",
                )
            elif link.is_fixed:
                yield _finding(link, _twin(robot, link, of_id))


def _finding(link: Link, twin: Link | None) -> Finding:
    products = link.rule.generic_products
    what = (
        f"Every {products[0]} matches" if products else f"A second device {' or '.join(link.rule.usb_ids)} matches too"
    )
    return finding(
        link.name,
        f"{what}: {link.path} points to the one found last",
        advice="add ATTRS{serial}, or match the USB port with KERNELS or ENV{ID_PATH}",
        related=[note(twin.name, "a device with these ids, too")] if twin else [],
        severity=None if twin else "info",
    )


def _twin(robot: Robot, link: Link, of_id: dict[str, list[Link]]) -> Link | None:
    """The link that another rule makes for a second device of the same ids on this robot."""
    for other in of_id[link.rule.usb_ids[0]][:_MOST_RIVALS]:
        if other.path == link.path or not other.rule.judged or other.rule.is_serial != link.rule.is_serial:
            continue
        if not robot.devices.renamed.isdisjoint(((link.path, other.path), (other.path, link.path))):
            continue
        opened = _is_beside(other, link) or robot.devices.names(link.path)
        if opened and robot.same_robot(other.name, link.name):
            return other
    return None


def _is_beside(one: Link, other: Link) -> bool:
    folder, _, _ = one.name.span.path.rpartition("/")
    return folder == other.name.span.path.rpartition("/")[0]
