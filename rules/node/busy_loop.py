"""A loop that never waits takes a whole core.

## What it finds
In Python nodes, and the Python programs and modules beside them, a loop that asks a serial port (`in_waiting`), MAVLink
(`recv_match()` without `blocking=True`) or a queue (`get_nowait()`) and, when nothing has come, asks again at once: no
sleep, no wait, no blocking call. The same for a loop that reads a pin (`GPIO.input()`) and waits for one of its values
alone, or for none. In C++, a loop that only calls `spin_some()`, which returns at once when there is nothing to do,
whatever duration it gets.
Loops that end after some time are left out.

## Why it matters on a robot
The loop takes 100 % of a core, on a computer with four of them. The processor gets hot and slow, the battery goes
down, and other nodes, such as those that drive, get their time late. In Python the loop also holds the interpreter's
lock most of the time: callbacks and other threads of the node come late.

## Bad
```python
while rclpy.ok():
    if self.port.in_waiting:
        self.read()
```

## Good
```python
while rclpy.ok():
    line = self.port.readline()   # returns after the timeout of the port
    if line:
        self.publish(line)
```

## When to ignore it
When the core is reserved for this loop, which may not lose a microsecond.

## References
- rclcpp, executor.cpp: `spin_some_impl` waits for work with a timeout of 0
- pyserial: `in_waiting`; pymavlink, mavutil.py: `recv_match`; https://docs.python.org/3/library/queue.html
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import nodes
from bringup_lint.api import note
from bringup_lint.api import rule


@rule("warning", silent="top shows the process with 100 % of a core")
def busy_loop(robot: Robot) -> Iterator[Finding]:
    for file in robot.nodes.robot_code:
        for found in nodes.busy_loops(robot.nodes.syntax(file)):
            when = "" if found.reads_pin else " when nothing has come"
            yield finding(
                file.span_of(found.asked),
                f"This returns at once{when}, and the loop asks again: it takes a whole core",
                advice="let the call block with a timeout, or sleep for a moment when nothing has come"
                if when
                else "sleep for a moment in each turn, or wait for the edge: GPIO.wait_for_edge()",
                related=[note(file.span_of(found.loop.test), "this loop never waits")],
                severity=robot.nodes.lowered_if_vendored(file.source, "warning"),
            )
    for node in robot.nodes.cpp:
        for spin in node.busy_spins:
            yield finding(
                spin.place,
                "spin_some() returns at once when there is nothing to do: this loop takes a whole core",
                advice="call spin() or spin_once() with a timeout, or sleep in the loop",
                related=[note(spin.loop, "this loop never waits")],
                severity=robot.nodes.lowered_if_vendored(node.source, "warning"),
            )
