"""A Cyclone DDS setting of another version.

## What it finds
An element, attribute or value that other versions of the library take, but not the one of the robot's
ROS distribution. When the tree does not tell the distribution, 0.10 is assumed (Humble to Kilted) and
the finding is a warning.

## Why it matters on a robot
What a version does not know is fatal to it: no participant, no ROS node. Configuration copied from the
newest manual fails on an older robot, and files of Foxy fail on Jazzy.

## Bad
```xml
<General>
  <Interfaces>                 <!-- Foxy -->
    <NetworkInterface name="eth0"/>
  </Interfaces>
</General>
```

## Good
```xml
<General>
  <NetworkInterfaceAddress>eth0</NetworkInterfaceAddress>
</General>
```

## References
- 0.7.0, 0.9.1, 0.10.5, 11.0.1, tried with the real libraries; 0.8.2 from its source
- https://github.com/ros2/rmw_cyclonedds/issues/467
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import rule
from bringup_lint.api.schema import Code


@rule("error", symptoms=["unknown element", "unknown attribute", "out of range", "not a decimal integer"])
def element_too_new(robot: Robot) -> Iterator[Finding]:
    for configuration, remark in robot.dds.remarks(Code.UNKNOWN, Code.UNKNOWN_ATTRIBUTE, Code.VALUE, Code.RANGE):
        versions = robot.dds.accepted_by(configuration, remark)
        if not versions:
            continue
        library = robot.dds.cyclonedds
        yield finding(
            remark.where,
            f"{library} does not take '{remark.where}', only {', '.join(versions)} does: no node starts",
            advice=f"write what {library.version} knows, or set target-ros to the robot's distribution",
            severity=None if library.known else "warning",
        )
