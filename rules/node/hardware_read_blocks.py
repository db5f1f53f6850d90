"""Hardware of ros2_control waits for a packet in its read().

## What it finds
In the source of a system or actuator: `read()`, `recv()` or `recvfrom()` of a socket in its method `read()`, when
nothing in the source or its header makes the socket return without a packet (`O_NONBLOCK`, `SO_RCVTIMEO`,
`MSG_DONTWAIT`, `poll`, `select`, a thread of its own).

## Why it matters on a robot
The controller manager calls `read()`, the controllers and `write()` one after the other in one thread. When a drive is
switched off or the cable is out, `read()` never returns: no command is written any more, and the drives that still run
keep their last one. The error that the method would return never comes.

## Bad
```cpp
socket_ = ::socket(PF_CAN, SOCK_RAW, CAN_RAW);
// in read():
if (::read(socket_, &frame, sizeof(frame)) != sizeof(frame)) return return_type::ERROR;
```

## Good
```cpp
const timeval limit{0, 2000};
setsockopt(socket_, SOL_SOCKET, SO_RCVTIMEO, &limit, sizeof(limit));
```

## When to ignore it
When a function of another package sets the time-out.

## References
- socket(7), SO_RCVTIMEO
- ros2_control, ros2_control_node.cpp: read, update and write in one loop
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import nodes
from bringup_lint.api import note
from bringup_lint.api import rule


@rule("warning", silent="the loop of the controller manager stops without a message")
def hardware_read_blocks(robot: Robot) -> Iterator[Finding]:
    for found in nodes.blocking_reads(robot.nodes):
        yield finding(
            found.place,
            f"{found.call}() waits until a packet arrives: with a silent bus the whole controller manager hangs",
            advice="open the socket with O_NONBLOCK, or set SO_RCVTIMEO to less than a cycle",
            related=[note(found.opened, "opened here, without a time-out")],
            severity=robot.nodes.lowered(found.source, "warning"),
        )
