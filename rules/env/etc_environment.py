"""ROS variables are set in a file that services do not read.

## What it finds
`ROS_*`, `RMW_*`, CycloneDDS and Fast DDS variables in `/etc/environment`, when a ROS service of the tree neither
reads that file (`EnvironmentFile=`, a script, PAM) nor gets the variable elsewhere.

## Why it matters on a robot
PAM reads `/etc/environment` at login, and a system service has no login. The developer's shell is in domain 42 with
CycloneDDS, while the robot's nodes are in domain 0 with the default middleware. `ros2 topic list` shows nothing,
and nothing is reported as failed.

## Bad
```bash
# /etc/environment
ROS_DOMAIN_ID=42
```

## Good
```ini
[Service]
EnvironmentFile=/etc/environment
```

## When to ignore it
When the variable is meant only for login shells and the services need its default.

## References
- pam_env(8)
- systemd.exec(5), "Environment Variables in Spawned Processes"
"""

import re
from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import note
from bringup_lint.api import regex
from bringup_lint.api import rule
from bringup_lint.api.systemd import Unit
from bringup_lint.api.systemd import Units

PATH = "/etc/environment"
OF_ROS = regex(r"(?:ROS|RMW|CYCLONEDDS|FASTRTPS|FASTDDS|RCUTILS)_|AMENT_PREFIX_PATH$")


@rule("warning", silent="systemd does not read the file, so the variable is just not set")
def etc_environment(robot: Robot) -> Iterator[Finding]:
    units = robot.units
    file = robot.environment_file(PATH) if units.ros else None
    if file is None:
        return
    for entry in file.entries:
        blind = [unit for unit in units.ros if OF_ROS.match(entry.name) and _is_blind(units, unit, str(entry.name))]
        if blind:
            names = ", ".join(unit.name for unit in blind[:3]) + (" and others" if len(blind) > 3 else "")
            yield finding(
                entry.name,
                f"System services do not read {PATH}: {entry.name} is not set for {names}",
                advice=f"add EnvironmentFile={PATH} to the units, or keep the variables in a separate file",
                related=[note(unit.where, f"{unit.name} starts ROS without it") for unit in blind[:3]],
            )


def _is_blind(units: Units, unit: Unit, name: str) -> bool:
    if unit.manager == "user" or any(PATH in text for process in units.processes(unit) for text in process.texts):
        return False
    if any(file.path in (PATH, None) for file in units.environment_files(unit)):
        return False
    return units.environment(unit).defines(name) is False and not any(
        re.search(rf"\b{re.escape(name)}=", text) for process in units.processes(unit) for text in process.texts
    )
