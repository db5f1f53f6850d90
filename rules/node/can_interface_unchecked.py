"""A CAN driver does not notice that its interface does not exist.

## What it finds
`ioctl(socket, SIOCGIFINDEX, ...)` of a CAN socket whose result nobody looks at, when the function then calls `bind()`
with the index and looks at neither that nor `errno` before. A request that was given another index on purpose is left
out.

## Why it matters on a robot
The request fails when there is no interface of this name: the adapter is not plugged in, its driver comes later, or it
has another number after the reboot. A request that was made as zero then holds the index 0, with which `bind()`
succeeds: it stands for all CAN interfaces. The node starts, hears other buses, and each of its writes fails. Without
the zero the index is whatever was in memory: mostly `bind()` fails then, with an error that names no interface, and
sometimes it finds a 0 there.

## Bad
```cpp
ioctl(socket_, SIOCGIFINDEX, &request);
```

## Good
```cpp
if (ioctl(socket_, SIOCGIFINDEX, &request) < 0) throw std::system_error(errno, std::generic_category(), name);
```

## When to ignore it
When something before has made sure that the interface exists.

## References
- netdevice(7), SIOCGIFINDEX
- https://docs.kernel.org/networking/can.html: with the index 0 a socket is bound to all CAN interfaces
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import note
from bringup_lint.api import rule

BY_CHANCE = (
    "Without the CAN interface bind() takes the index that the request held before: it fails without the name, or "
    "takes 0, all CAN interfaces"
)


@rule("warning", silent="the failed ioctl() logs nothing")
def can_interface_unchecked(robot: Robot) -> Iterator[Finding]:
    for driver in robot.nodes.drivers:
        for found in driver.unchecked_indexes:
            held = "the index that the request held before"
            taken = "index 0, all CAN interfaces, and each write fails" if found.is_zero else held
            message = f"Nothing notices that the CAN interface does not exist: bind() takes {taken}"
            yield finding(
                found.asked,
                message if found.is_zero or found.is_blind else BY_CHANCE,
                advice="check the result of ioctl(), and report errno with the name of the interface",
                related=[note(found.bound, "bound with the index")],
                severity=robot.nodes.lowered_if_vendored(driver.source, "warning"),
            )
