"""A value of a message has another unit than its definition gives.

## What it finds
- `BatteryState.percentage` and `RelativeHumidity.relative_humidity`, which are 0 to 1, with percentages: a limit of 5
  or more for a value that comes in, and numbers, `... * 100` or the `capacity` of a power supply for one that goes out.
  Limits are left alone where the tree itself publishes percentages, or sets the parameter that holds them to a share.
- Degrees (`math.degrees()`) in angles and speeds that are rad and rad/s: those of `LaserScan`, `Imu`, `Twist`, and of
  the `JointState` on `joint_states`.
- In Python, `FluidPressure` with the `pressure` of a chip whose CircuitPython library gives hPa, such as
  `adafruit_bme280`, and `MagneticField` with a `magnetic` that is in µT, such as that of `adafruit_bno055`.

## Why it matters on a robot
A full battery is 1.0, which is below every limit in percent: the robot lands, docks or shuts down at the first message.
The other way round, 15 for an empty battery is above every limit. An angle in degrees is 57 times too large. A
pressure that is a hundred times too small is that of a height of 30 km.

## Bad
```python
def on_battery(self, msg):
    if msg.percentage < 20.0:
        self.dock()
```

## Good
```python
def on_battery(self, msg):
    if msg.percentage < 0.2:
        self.dock()
```

## When to ignore it
When the driver on the other side is known to publish percentages; dividing by 100 in one place is better.

## References
- https://docs.ros.org/en/jazzy/p/sensor_msgs/msg/BatteryState.html
- https://www.ros.org/reps/rep-0103.html
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import nodes
from bringup_lint.api import note
from bringup_lint.api import rule


@rule("warning", confidence="medium", silent="a number has no unit on the wire")
def message_unit(robot: Robot) -> Iterator[Finding]:
    for found in nodes.wrong_units(robot.nodes):
        yield finding(
            found.place,
            _message(found),
            advice=_advice(found),
            related=[note(found.declared, "the limit is the default of this parameter")] if found.declared else [],
            severity=robot.nodes.lowered(found.place.source, "warning"),
        )


def _advice(found: nodes.WrongUnit) -> str:
    if found.chip is not None:
        return f"convert it from {found.got} to {found.chip.unit}"
    return "convert it to radians" if found.got == "degrees" else "use the range from 0 to 1"


def _message(found: nodes.WrongUnit) -> str:
    name = f"{found.field} of {found.type.rpartition('/')[2]}"
    if found.chip is not None:
        return f"{name} is in {found.chip.unit}, and is set to {found.got}: readers take it for {found.chip.readers}"
    if found.got == "degrees":
        return f"{name} is in rad, and is set to degrees: readers take it for 57 times as much"
    if found.is_read:
        return f"{name} is 0 to 1, and the limit is {found.got}: a full charge is below it, too"
    return f"{name} is 0 to 1, and is set to {found.got or 'a percentage'}: readers take any charge for full"
