r"""ModemManager talks to a robot's serial port.

## What it finds
A rule that makes a link for a USB serial device that ModemManager probes (STM32, Arduino, flight controllers
and others), without `ENV{ID_MM_DEVICE_IGNORE}="1"`:
- **warning**: the tree has a ModemManager.service that is not masked.
- **info**: the tree is a repository without ModemManager.service, so the robot may have it.

## Why it matters on a robot
ModemManager sends AT commands to every new ttyACM. The firmware reads garbage for the first seconds, and some
boards enter their boot loader.

## Bad
```udev
SUBSYSTEM=="tty", ATTRS{idVendor}=="0483", ATTRS{idProduct}=="5740", KERNELS=="1-1.2", SYMLINK+="robot/base"
```

## Good
```udev
SUBSYSTEM=="tty", ATTRS{idVendor}=="0483", ATTRS{idProduct}=="5740", KERNELS=="1-1.2", \
  SYMLINK+="robot/base", ENV{ID_MM_DEVICE_IGNORE}="1"
```

## When to ignore it
If ModemManager is not installed on the robot, or runs with the strict filter policy and the device is known
to be skipped.

## References
- https://github.com/rusefi/rusefi/issues/4359
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import fix
from bringup_lint.api import rule

_IGNORE = ("ID_MM_DEVICE_IGNORE", "ID_MM_PORT_IGNORE", "ID_MM_DEVICE_PROCESS")


@rule("warning", fix="unsafe", symptoms=["ModemManager", "[modem0] state changed"])
def modemmanager_not_ignored(robot: Robot) -> Iterator[Finding]:
    manager = robot.units.candidates("ModemManager.service")
    running = any(not unit.masked for unit in manager)
    if (manager and not running) or (robot.tree.complete and not manager):
        return
    for line in robot.udev.judged:
        device = line.usb_device if line.is_serial and line.links else None
        if device is None or not device["modemmanager"] or robot.udev.set_of(line).sets_beside(line, "ENV", *_IGNORE):
            continue
        yield finding(
            line.usb_number,
            f"ModemManager sends AT commands to the {device['product']} when it is connected",
            advice='add ENV{ID_MM_DEVICE_IGNORE}="1"',
            severity=None if running else "info",
            fix=fix("keep ModemManager away", line.after('ENV{ID_MM_DEVICE_IGNORE}="1"')),
        )
