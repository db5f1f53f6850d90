"""Processes of one robot are set up for different domains or middlewares.

## What it finds
ROS_DOMAIN_ID or RMW_IMPLEMENTATION with different values in units that are started together, or in services of one
compose file. Values that are not known, and processes that bridge domains, are left alone.

## Why it matters on a robot
They do not see each other: each part works for itself, topics of the other part are missing without a word.

## Bad
```sh
# drivers.service
Environment=ROS_DOMAIN_ID=42
# navigation.service
Environment=ROS_DOMAIN_ID=0
```

## Good
```sh
# both units
EnvironmentFile=/etc/robot/ros.env
```

## References
- https://github.com/hucebot/g1pilot/issues/30
- https://github.com/ros2/ros2cli/issues/1009
"""

import re

from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import note
from bringup_lint.api import rule

BRIDGE = re.compile(r"bridge|domain", re.I)


@rule(
    "warning",
    symptoms=["no topics", "nodes do not see each other"],
    aliases=["env/set-twice-mismatch", "env/rmw-inconsistent-across-units"],
)
def conflict_between_sources(robot: Robot):
    for name in ("ROS_DOMAIN_ID", "RMW_IMPLEMENTATION"):
        for group in _together(robot):
            found = [(process, variable) for process in group if (variable := _known(process, name))]
            values: dict[str, list] = {}
            for process, variable in found:
                values.setdefault(variable.text, []).append((process, variable))
            if len(values) < 2:
                continue
            usual = max(values.values(), key=len)
            for text, users in values.items():
                if users is usual:
                    continue
                process, variable = users[0]
                other, common = usual[0]
                yield finding(
                    variable.value,
                    f"{process.name} has {name}={text}, {other.name} {name}={common.text}: they do not see each other",
                    advice="keep the variable in one environment file that all of them read",
                    related=[note(common.value, f"{other.name} gets its value here")],
                )


def _known(process, name):
    variable = process.environment.get(name)
    if variable is None or not variable.text or BRIDGE.search(process.name):
        return None
    return variable


def _together(robot: Robot):
    """Processes that certainly belong to one robot: units of one place, services of one compose file."""
    groups: dict[object, list] = {}
    for process in robot.ros.processes:
        key = process.unit.place if process.unit else process.source.name
        groups.setdefault((process.unit is None, key), []).append(process)
    return groups.values()
