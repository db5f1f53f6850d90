"""This distribution does not read the variable of the Fast DDS profile.

## What it finds
Only FASTDDS_DEFAULT_PROFILES_FILE on Humble to Jazzy, whose Fast DDS 2 reads FASTRTPS_DEFAULT_PROFILES_FILE. Or
only FASTRTPS_DEFAULT_PROFILES_FILE on Kilted and newer.

## Why it matters on a robot
Fast DDS never loads the profile file, and no message says so. Multicast discovery stays on, and the peers and
limits are missing.

## Bad
```sh
FASTDDS_DEFAULT_PROFILES_FILE=/etc/robot/fastdds.xml      (on Jazzy)
```

## Good
```sh
FASTRTPS_DEFAULT_PROFILES_FILE=/etc/robot/fastdds.xml
```

## When to ignore it
When the robot runs a Fast DDS version that was not released with its distribution.

## References
- tried with Fast DDS 2.14.5
- https://github.com/ros2/ros2_documentation/pull/6098
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import note
from bringup_lint.api import rule
from bringup_lint.api.ros import at_least

OLD, NEW = "FASTRTPS_DEFAULT_PROFILES_FILE", "FASTDDS_DEFAULT_PROFILES_FILE"


@rule("error", silent="Fast DDS does not look at variables that it does not know")
def fastdds_profiles_var_wrong_for_distro(robot: Robot) -> Iterator[Finding]:
    newer = at_least(robot.target.ros, "kilted")
    if newer is None or not robot.may_hold(OLD, NEW):
        return
    wrong, right = (OLD, NEW) if newer else (NEW, OLD)
    for process in robot.ros.processes:
        environment = process.environment
        rmw = environment.get("RMW_IMPLEMENTATION")
        if rmw is not None and (rmw.text is None or "fastrtps" not in rmw.text):
            continue
        found = environment.get(wrong)
        if found is not None and environment.complete and right not in environment:
            yield finding(
                found.value,
                f"Fast DDS of {robot.target.ros} does not read {wrong}: {process.name} never loads the profile",
                advice=f"set {right}",
                related=[note(process.where, f"{process.name} gets the variable")],
            )
