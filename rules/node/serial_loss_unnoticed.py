"""A loop reads a serial port that is gone again and again, at full speed.

## What it finds
A loop of a C++ source that calls `read()` for a serial port and, whether that returns 0 or -1, only logs and reads
again: it does not wait, leave the loop, throw, count, set a flag, or close the port.

## Why it matters on a robot
When the USB adapter is unplugged, or resets for a moment, `read()` returns 0 or -1 at once, each time. The loop takes a
whole core from the other nodes. The port is never opened again, so no data comes until somebody restarts the node,
which stays alive: launch and systemd see nothing to restart.

## Bad
```cpp
while (rclcpp::ok()) {
  const ssize_t n = read(fd_, buffer, sizeof(buffer));
  if (n <= 0) continue;
  decode(buffer, n);
}
```

## Good
```cpp
while (rclcpp::ok()) {
  pollfd port{fd_, POLLIN, 0};
  if (poll(&port, 1, 100) > 0 && (port.revents & (POLLHUP | POLLERR))) { reopen(); continue; }
  ...
}
```

## When to ignore it
When another thread notices that no data comes, and ends the process.

## References
- Linux, drivers/tty/tty_io.c: `hung_up_tty_read` returns 0
- read(2)
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import note
from bringup_lint.api import rule


@rule("warning", silent="the process stays alive, and read() logs nothing")
def serial_loss_unnoticed(robot: Robot) -> Iterator[Finding]:
    for driver in robot.nodes.drivers:
        for found in driver.idle_reads:
            yield finding(
                found.read,
                "When the serial port is unplugged, this returns 0 or -1 at once: the loop takes a whole core, and no "
                "data comes until the node is restarted",
                advice="open the port again, or end the node, after POLLHUP or an error of read()",
                related=[note(found.loop, "goes on whatever read() returns")],
                severity=robot.nodes.lowered_if_vendored(driver.source, "warning"),
            )
