"""A CAN driver does not notice that its interface does not exist.

## What it finds
`ioctl(socket, SIOCGIFINDEX, ...)` of a CAN socket whose result nobody looks at, when the function then calls `bind()`
with the index and compares that with nothing.

## Why it matters on a robot
The request fails when there is no interface of this name: the adapter is not plugged in, its driver comes later, or it
has another number after the reboot. A request that was made as zero then holds the index 0, with which `bind()`
succeeds: it stands for all CAN interfaces. The node starts, hears other buses, and each of its writes fails. Without
the zero the index is whatever was in memory, and so is the error that `bind()` reports.

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


@rule("warning", silent="the failed ioctl() logs nothing")
def can_interface_unchecked(robot: Robot) -> Iterator[Finding]:
    for driver in robot.nodes.drivers:
        for found in driver.unchecked_indexes:
            taken = "index 0, all CAN interfaces, and each write fails" if found.is_zero else "an index that nobody set"
            yield finding(
                found.asked,
                f"Nothing notices that the CAN interface does not exist: bind() takes {taken}",
                advice="check the result of ioctl(), and report errno with the name of the interface",
                related=[note(found.bound, "bound with the index")],
                severity=robot.nodes.lowered_if_vendored(driver.source, "warning"),
            )
