"""Two nodes of one program open the same device.

## What it finds
The same serial port or camera as the same parameter of two nodes that run the same program and start together. Buses
and chips that programs share, such as I2C, SPI and GPIO, are left alone.

## Why it matters on a robot
A line that was copied keeps the port of the first device. Two processes that read one serial port take each other's
bytes, a second one is refused by a camera, and the second device is never opened.

## Bad
```python
Node(package='lift', executable='jack', name='front', parameters=[{'port': '/dev/jack_front'}]),
Node(package='lift', executable='jack', name='rear', parameters=[{'port': '/dev/jack_front'}]),
```

## Good
```python
Node(package='lift', executable='jack', name='front', parameters=[{'port': '/dev/jack_front'}]),
Node(package='lift', executable='jack', name='rear', parameters=[{'port': '/dev/jack_rear'}]),
```

## When to ignore it
When the program only names the device in its messages, or hands it to a process that serves both.

## References
- tty_ioctl(4), TIOCEXCL: without it a serial port can be opened several times
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import note
from bringup_lint.api import rule
from bringup_lint.api.launch import shared_devices


@rule(
    "warning",
    symptoms=[
        "device reports readiness to read but returned no data (device disconnected or multiple access on port?)",
        "Could not exclusively lock port",
        "Device or resource busy: '/dev/",
        "/dev/*: Device or resource busy",
        "/dev/*Resource busy",
    ],
)
def device_shared(robot: Robot) -> Iterator[Finding]:
    for shared in shared_devices(robot.launch):
        first, second = shared.other.label(), shared.node.label()
        yield finding(
            shared.path,
            f"{second} opens {shared.path} like {first}: they take each other's data, and one device stays closed",
            advice=f"give {second} its own device",
            related=[note(shared.first, f"{first} opens it here")],
        )
