"""ROS 2 overwrites the QoS of a Fast DDS file.

## What it finds
A profiles file that sets reliability, durability, history or publish mode of writers or readers, and that a
process reads without `RMW_FASTRTPS_USE_QOS_FROM_XML=1`. The environment of the process has to be completely
known.

## Why it matters on a robot
Without the variable the RMW overwrites these settings with those of the program. What the file sets has no
effect, and no message reports it.

## Bad
```xml
# FASTRTPS_DEFAULT_PROFILES_FILE=/etc/robot/fastdds.xml
<data_writer profile_name="/odom">
  <qos>
    <reliability>...</reliability>
  </qos>
</data_writer>
```

## Good
```xml
# RMW_FASTRTPS_USE_QOS_FROM_XML=1
<data_writer profile_name="/odom">...</data_writer>
```

## When to ignore it
If the file is shared with processes that set the variable, and this one should use the QoS of the program.

## References
- rmw_fastrtps, README, "Full QoS configuration"
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import note
from bringup_lint.api import rule
from bringup_lint.api.fastdds import overwritten_qos


@rule("warning", silent="rmw_fastrtps overwrites the values without a message")
def qos_from_xml_off(robot: Robot) -> Iterator[Finding]:
    for profiles in robot.dds.profile_files:
        endpoints = [profile for kind in ("data_writer", "data_reader") for profile in profiles.of_kind(kind)]
        overwritten = [element for profile in endpoints for element in overwritten_qos(profile)]
        if not overwritten or profiles.dropped:
            continue
        for process, variable in robot.dds.profile_readers(profiles):
            switch = process.environment.get("RMW_FASTRTPS_USE_QOS_FROM_XML")
            if switch is None and process.environment.defines("RMW_FASTRTPS_USE_QOS_FROM_XML") is not False:
                continue
            if switch is not None and switch.text in (None, "1"):
                continue
            yield finding(
                overwritten[0].name,
                f"{process.name} does not set RMW_FASTRTPS_USE_QOS_FROM_XML=1: the RMW overwrites this QoS",
                advice="set RMW_FASTRTPS_USE_QOS_FROM_XML=1 in the same environment, or delete the QoS",
                related=[note(variable, f"{process.name} reads the file")],
            )
            break
