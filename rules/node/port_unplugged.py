"""An unplugged serial adapter ends the node or its thread.

## What it finds
Python nodes that read or write a serial port, or ask it for `in_waiting`, in a callback or a thread of their own and
outside every `try` that takes the exception, also through a method of a class of the workspace. Callbacks only where
nothing is seen to start the node again: `respawn` or `on_exit` in a launch file, a unit or container that runs it by
itself. `except serial.SerialException` does not take the OSError of `in_waiting`, which pyserial hands on as it is.

## Why it matters on a robot
Cables of USB adapters come loose, and a dip of the supply resets the chip: the device is gone for a second. The next
access raises an exception. In a callback it ends the node, and nothing starts it again; in a thread it ends the thread
alone, the node stays in `ros2 node list`, and its data stop without a word.

## Bad
```python
def on_time(self):
    if self.port.in_waiting:
        line = self.port.readline()
```

## Good
```python
def on_time(self):
    try:
        if self.port.in_waiting:
            line = self.port.readline()
    except OSError:  # also serial.SerialException
        self.reopen()
```

## When to ignore it
When the robot is to end all programs as soon as one of them fails, and something starts them again.

## References
- pyserial 3.5, serialposix.py: `in_waiting` calls ioctl, `read` and `write` raise SerialException
- https://pyserial.readthedocs.io/en/latest/pyserial_api.html#exceptions
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import nodes
from bringup_lint.api import note
from bringup_lint.api import rule


@rule(
    "warning",
    symptoms=[
        "serial.serialutil.SerialException: device reports readiness to read but returned no data",
        "OSError: [Errno 5] Input/output error",
    ],
)
def port_unplugged(robot: Robot) -> Iterator[Finding]:
    for each in nodes.unplugged_ports(robot.nodes):
        end = nodes.end_of(robot.nodes.syntax(each.file), each.node)
        stays = "" if each.is_thread else ", and nothing starts it again"
        raised = "OSError, which is no SerialException," if each.raises == "OSError" else each.raises
        yield finding(
            each.file.span_of(each.node),
            f"An unplugged adapter raises {raised} in {each.name}(), and nothing catches it: {end}{stays}",
            advice="catch OSError, which is also SerialException, close the port and open it again",
            related=[note(each.opened, "the port")],
            severity=robot.nodes.lowered_if_vendored(each.file.source, "warning"),
        )
