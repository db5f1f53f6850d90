"""A Cyclone DDS setting is for another version of the library.

## What it finds
An element, attribute or value that other versions of the library accept, but not the version of the robot's
ROS distribution. If the tree does not show the distribution, version 0.10 is assumed (Humble to Kilted) and
the finding is a warning.

## Why it matters on a robot
The library refuses what its version does not know: no participant is created and no ROS node starts.
Configuration copied from the newest manual fails on an older robot, and files for Foxy fail on Jazzy.

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

## When to ignore it
If the robot has another version of the library than its distribution, for example one that you build in the
workspace.

## References
- 0.7.0, 0.9.1, 0.10.5, 11.0.1, tested with the real libraries; 0.8.2 from its source
- https://github.com/ros2/rmw_cyclonedds/issues/467
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import rule
from bringup_lint.api.cyclonedds import versions_with
from bringup_lint.api.schema import Code


@rule("error", symptoms=["unknown element", "unknown attribute", "out of range", "not a decimal integer"])
def element_too_new(robot: Robot) -> Iterator[Finding]:
    for _, remark in robot.dds.remarks(Code.UNKNOWN, Code.UNKNOWN_ATTRIBUTE, Code.VALUE, Code.RANGE):
        versions = versions_with(remark)
        if not versions:
            continue
        library = robot.dds.cyclonedds
        yield finding(
            remark.where,
            f"{library} does not accept '{remark.where}' (accepted by {', '.join(versions)}): no node starts",
            advice=f"use a setting that {library.version} supports, or set target-ros to the robot's distribution",
            severity=None if library.known else "warning",
        )
