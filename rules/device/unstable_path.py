"""A device path contains a number that changes.

## What it finds
`/dev/ttyUSB0`, `/dev/ttyACM1`, `/dev/video2`, `/dev/input/event3`, `/dev/bus/usb/001/004` with any number. The
severity depends on the place:

- Warning: units and their environment files, compose, launch and parameter files, what a launch file gives to one that
  it includes, YAML of a driver in a folder such as `config/`, scripts, variables of Ansible's hosts and groups; the
  default of a launch argument where a unit launches the file without giving the argument a value.
- Info: any other default of a launch argument or of an Ansible role; the default of a driver in its own launch file;
  the only camera of the robot in a launch file, a script or code, and its first one in a parameter or compose file;
  cameras in a tree that installs a driver for GMSL, which are numbered by the device tree, and that speaks of no camera
  on USB.

In the source of a node it counts where it is opened, also under the name of a constant, and in a module that a node
imports.

Several uses of one path in a file are one finding.

On-board ports (ttyS, ttyTHS, ttyAMA), links by id or path, and files for simulation are not reported.

## Why it matters on a robot
The numbers follow the order in which devices are found. After a reboot the IMU is ttyUSB1 and the motor controller
ttyUSB0: each driver talks to the wrong device. A port that is open when its plug comes loose keeps its number, so that
even the only adapter of a robot comes back with the next one.

## Bad
```ini
[Service]
Environment=IMU_PORT=/dev/ttyUSB0
```

## Good
```ini
[Service]
Environment=IMU_PORT=/dev/robot/imu
```

## When to ignore it
When the robot has exactly one device of this kind and no free port where a second one could be plugged in.

## References
- udev(7), SYMLINK
- https://github.com/RoverRobotics-archive/roverrobotics_ros2/issues/16
"""

import re
from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Located
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import note
from bringup_lint.api import regex
from bringup_lint.api import rule
from bringup_lint.api.host import DeviceUse
from bringup_lint.api.udev import Link

WORD = regex(r"[a-z]{3,}")
OF_EVERY_DEVICE = frozenset(
    ("dev", "tty", "ttyusb", "ttyacm", "usb", "acm", "port", "serial", "device", "robot", "input", "event")
)
GMSL = regex(
    r"^(?![ \t]*(?:\*|//))[^#\n]{0,200}?gmsl[^#\n]{0,80}(?:driver|overlay|\.deb\b|\.dtbo?\b|\.ko\b)",
    re.I | re.M,
    "gmsl",
)
"""The driver of links of cameras to the board itself: the device tree gives them their numbers."""
USB_CAMERA = regex(
    r"usb[ _-]{0,2}(?:video|(?:web)?cam)|webcam|\buvc|realsense|/dev/v4l/", re.I, "usb webcam uvc realsense v4l"
)
PAGE = regex(r"\.(?:md|rst|txt|adoc)$", re.I)
MOST = 200_000
"""Characters of a page that are read."""
_SEVERITY = {"argument": "info"}
FIRST = ("/dev/ttyUSB0", "/dev/ttyACM0")
_RANK = ("literal", "unit", "host", "default", "script", "argument")


@rule(
    "warning",
    symptoms=[
        "could not open port /dev/tty*: [Errno 2] No such file or directory",
        "Serial port not found. | device: /dev/tty*, error 2, waiting for connection",
        "Could not open device /dev/tty",
        "cannot bind to the specified [serial port:/dev/tty",
        "cannot bind to the specified serial port /dev/",
        "IO Exception (2): No such file or directory",
        "open device error | device: /dev/tty*, errno: 2",
        "Serial port not found. | device: /dev/tty",
        "Device specified is not available or is not a vaild V4L2 device",
        "/dev/tty*No such file or directory",
        "No such file or directory: '/dev/tty",
        "Could not open serial port",
        "Failed to open serial port /dev/tty",
        "An exception was thrown: open: No such file or directory",
        "DeviceError:serial:open: No such file or directory",
    ],
)
def unstable_path(robot: Robot) -> Iterator[Finding]:
    found: dict[tuple[str, str], list[tuple[DeviceUse, list[Link]]]] = {}
    for use, links in robot.devices.unstable:
        found.setdefault((use.path.span.path, str(use.path)), []).append((use, links))
    for uses in found.values():
        (use, links), *others = sorted(uses, key=lambda one: _RANK.index(one[0].certainty))
        yield _finding(robot, use, links, [other for other, _ in others])


def _finding(robot: Robot, use: DeviceUse, links: list[Link], others: list[DeviceUse]) -> Finding:
    severity = _SEVERITY.get(use.certainty)
    beside = robot.devices.beside(use)
    if use.certainty == "argument" and (beside is not None or _is_launched_at_boot(robot, use)):
        severity = "warning"
    if robot.devices.is_single_camera(use) or robot.devices.is_default(use):
        severity = "info"
    if use.path.startswith("/dev/video") and _has_fixed_cameras(robot):
        severity = "info"
    return finding(
        use.path,
        f"{use.path} is numbered in the order of discovery: {_then(use.path, beside)}",
        advice=_advice(robot, use, links),
        related=[
            *(note(link.name, f"creates {link.path}") for link in links[:3]),
            *(note(each, "opened here") for each in [use.opened_elsewhere] if each is not None),
            *(note(other.path, "also used here") for other in others[:10]),
            *(note(each, "another device of this kind") for each in [beside] if each is not None),
        ],
        severity=severity,
        chain=robot.provenance.chain_to(use.path, f"{use.path} is opened"),
    )


def _then(path: str, beside: Located | None) -> str:
    """What comes of the number. The first of its kind keeps it for as long as nothing else is plugged in."""
    if beside is None and path in FIRST:
        return "a second adapter, or a plug that comes loose while the port is open, changes the number"
    return "after a reboot it may be another device"


def _has_fixed_cameras(robot: Robot) -> bool:
    """Whether the cameras of the robot are on GMSL, and none is known to be on USB."""
    if not robot.mentions(GMSL) or robot.mentions(USB_CAMERA):
        return False
    return not robot.tree.says(PAGE, MOST, USB_CAMERA)


def _advice(robot: Robot, use: DeviceUse, links: list[Link]) -> str:
    """The link of the device: one whose words, but for those of the robot, are all in the name of the file or the line
    that uses it, or that may be it."""
    said = _words(f"{use.path.span.source.basename} {use.path.span.source.line_text(use.path.span.line)}")
    of_robot = {word for package in robot.launch.workspace.packages for word in _words(package)} if links else set()
    named = []
    for link in links:
        words = _words(link.path) - of_robot - _words(link.name.span.source.basename)
        if words and words <= said:
            named.append(link)
    names = " or ".join(link.path for link in (named or links)[:3])
    if named:
        return f"use {names}"
    if links:
        return f"use {names} if that is the device, or create a link with a udev rule"
    return f"create a link with a udev rule, or {_instead(use.path)}"


def _words(text: str) -> set[str]:
    return set(WORD.findall(text.lower())) - OF_EVERY_DEVICE


def _instead(path: str) -> str:
    """What else is stable for a device of this kind: where udev keeps its names."""
    if path.startswith("/dev/bus"):
        return "hand over /dev/bus/usb as a whole"
    if path.startswith("/dev/input"):
        return "use a path below /dev/input/by-id"
    folder = "/dev/v4l/by-id or /dev/v4l/by-path" if path.startswith("/dev/video") else "/dev/serial/by-id"
    return f"use a path below {folder}"


def _is_launched_at_boot(robot: Robot, use: DeviceUse) -> bool:
    """Whether a unit launches the file of a launch argument without giving the argument a value."""
    source = use.path.span.source
    around = source.text[max(0, use.path.span.start - 200) : use.path.span.start]
    for each in robot.runners.launches:
        if each.file is None or each.file.source is not source or each.runner.unit is None:
            continue
        if not any(f"'{name}'" in around or f'"{name}"' in around for name, _ in each.arguments):
            return True
    return False
