"""Each packet that comes in becomes the target of what a driver sends.

## What it finds
In C++ sources an endpoint of Asio that is set to an address, sent to with `async_send_to` or `send_to`, and also handed
to `async_receive_from`, which writes the sender of each packet into it. Left out where the source compares it with an
address.

## Why it matters on a robot
`async_receive_from` takes the endpoint by reference. After the first packet of anything else, a port scan or another
robot, all commands go there, and the motor board or radio gets none until it sends something itself. Whoever wants to
takes the commands of the robot over with one packet. The write is also a data race with the thread that sends.

## Bad
```cpp
socket_.async_receive_from(buffer, endpoint_, handler);
socket_.async_send_to(command, endpoint_, sent);
```

## Good
```cpp
socket_.async_receive_from(buffer, sender_, handler);
socket_.async_send_to(command, endpoint_, sent);
```

## When to ignore it
When the socket is connected, or the driver is to answer whoever has sent last.

## References
- https://www.boost.org/doc/libs/release/doc/html/boost_asio/reference/basic_datagram_socket/async_receive_from.html
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import note
from bringup_lint.api import rule


@rule("warning", silent="packets go to another address, and nothing fails", tags=["CWE-940"])
def target_overwritten(robot: Robot) -> Iterator[Finding]:
    for driver in robot.nodes.drivers:
        for found in driver.taken_targets:
            yield finding(
                found.received,
                f"Each packet that comes in sets {found.name} to its sender, and what is sent goes there from then on",
                advice="receive into an endpoint of its own, and compare it with the one that is expected",
                related=[note(found.sent, "sends to it")],
                severity=robot.nodes.lowered_if_vendored(driver.source, "warning"),
            )
