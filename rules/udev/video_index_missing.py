r"""A camera link may point to a node without images.

## What it finds
A link for a USB camera (`SUBSYSTEM=="video4linux"`) without a match on `ATTR{index}` or
`ENV{ID_V4L_CAPABILITIES}`.

## Why it matters on a robot
Since Linux 4.16 a UVC camera has at least two nodes, of which the second is for metadata. Both match and the
last one keeps the link: the driver opens a node without images.

## Bad
```udev
SUBSYSTEM=="video4linux", ATTRS{idVendor}=="0c45", ATTRS{serial}=="C1", SYMLINK+="robot/camera"
```

## Good
```udev
SUBSYSTEM=="video4linux", ATTRS{idVendor}=="0c45", ATTRS{serial}=="C1", ATTR{index}=="0", \
  SYMLINK+="robot/camera"
```

## When to ignore it
If the camera has only one video node, as `v4l2-ctl --list-devices` shows on the robot.

## References
- Linux media documentation, V4L2_META_FMT_UVC
- udev(7), ATTR
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import fix
from bringup_lint.api import rule

_USB = {
    ("ATTRS", "idVendor"),
    ("ATTRS", "idProduct"),
    ("ATTRS", "serial"),
    ("SUBSYSTEMS", ""),
    ("KERNELS", ""),
}
_TELLING = {("ATTR", "index"), ("ATTRS", "index"), ("ENV", "ID_V4L_CAPABILITIES"), ("ENV", "ID_V4L_PRODUCT")}
_DECIDING = ("PROGRAM", "IMPORT", "RESULT", "TEST", "GOTO")


@rule(
    "warning",
    fix="unsafe",
    symptoms=["VIDIOC_G_FMT: Inappropriate ioctl for device", "not a video capture device"],
)
def video_index_missing(robot: Robot) -> Iterator[Finding]:
    for line in robot.udev.matching:
        if not line.is_for("video4linux") or not line.subjects & _USB or line.subjects & _TELLING:
            continue
        if any(line.line.first(key) for key in _DECIDING) or not all(map(line.is_any_number, line.kernels)):
            continue
        for link in line.links:
            if link.is_fixed:
                yield finding(
                    link.name,
                    f"A USB camera has at least two nodes: {link.path} may point to the one for metadata",
                    advice='add ATTR{index}=="0"',
                    fix=fix("match the first node", line.before(link.token, 'ATTR{index}=="0"')),
                )
