"""The kernel's console is on the serial line of a device.

## What it finds
`console=` in cmdline.txt, extlinux.conf or /etc/default/grub with a serial line that something of the robot opens as a
device: in a unit, script, compose, launch or parameter file, or a source of a node. `serial0` of the Raspberry Pi is
also /dev/ttyS0, which is a warning. Nothing where the tree has commands that take the console away again.

## Why it matters on a robot
The kernel writes its messages to the line, and systemd starts a login prompt on it, which reads half of what the
device sends. The motor controller gets text for commands, and the driver loses packets or never connects.

## Bad
```
console=serial0,115200 console=tty1 root=PARTUUID=0a1b-02 rootwait
```
with a driver that opens /dev/serial0

## Good
```
console=tty1 root=PARTUUID=0a1b-02 rootwait
```

## When to ignore it
When the image that is installed has another command line.

## References
- The Linux kernel documentation, "Linux Serial Console"
- systemd-getty-generator(8): a serial-getty@.service for each console
- https://www.raspberrypi.com/documentation/computers/configuration.html, "Configure UARTs"
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import note
from bringup_lint.api import rule
from bringup_lint.api.host import taken_consoles

MOST = 20


@rule("error", silent="the kernel and the login prompt write to the line and name no device")
def serial_console(robot: Robot) -> Iterator[Finding]:
    for console in taken_consoles(robot.files, robot.devices):
        first, *others = console.uses
        yield finding(
            console.line,
            f"The kernel and a login prompt use the serial line of {first.path}: the device there gets their text, and "
            "the prompt takes what it sends",
            advice=f"remove console={console.line} from the command line of the kernel",
            severity=None if console.certain else "warning",
            confidence=None if console.certain else "medium",
            related=[note(first.path, "opened here"), *(note(each.path, "here too") for each in others[:MOST])],
        )
