"""One disturbed transfer on the I2C bus ends the node or its thread.

## What it finds
Python nodes that read or write a chip on an I2C bus in a callback or a thread of their own, outside every `try` that
takes OSError: with `smbus`, `smbus2`, `busio`, the drivers of CircuitPython (`adafruit_*`) that are made with such a
bus, `mpu6050` and `ina219`; also through a method of a class of the workspace. Callbacks only where nothing is seen to
start the node again: `respawn` or `on_exit` in a launch file, a unit or container that runs it by itself.

## Why it matters on a robot
Wires of motors beside those of the bus, a loose plug or a dip of the supply: a chip misses its address now and then.
The kernel then answers "Remote I/O error". In a callback the exception ends the node, with all else that it does, and
nothing starts it again; in a thread it ends the thread alone, and the values stop without a word.

## Bad
```python
def on_time(self):
    self.publish(self.bus.read_i2c_block_data(0x68, 0x3B, 14))
```

## Good
```python
def on_time(self):
    try:
        data = self.bus.read_i2c_block_data(0x68, 0x3B, 14)
    except OSError as error:
        self.get_logger().warning(f'IMU: {error}', throttle_duration_sec=5.0)
        return
    self.publish(data)
```

## When to ignore it
When the robot is to end all programs as soon as one of them fails, and something starts them again.

## References
- https://docs.kernel.org/i2c/fault-codes.html: EREMOTEIO, ENXIO and ETIMEDOUT
- https://docs.python.org/3/library/exceptions.html#OSError
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
    symptoms=["OSError: [Errno 121] Remote I/O error", "OSError: [Errno 110] Connection timed out"],
)
def i2c_unhandled(robot: Robot) -> Iterator[Finding]:
    for each in nodes.lost_transfers(robot.nodes):
        end = nodes.end_of(robot.nodes.syntax(each.file), each.node)
        stays = "" if each.is_thread else ", and nothing starts it again"
        yield finding(
            each.file.span_of(each.node),
            f"One disturbed I2C transfer raises OSError, which {each.name}() does not catch: {end}{stays}",
            advice="catch OSError, leave this reading out, and go on",
            related=[note(each.where, "the transfer")] if each.where is not None else [],
            severity=robot.nodes.lowered_if_vendored(each.file.source, "warning"),
        )
