"""Processes of one robot use different domains or middlewares.

## What it finds
ROS_DOMAIN_ID or RMW_IMPLEMENTATION with different values in units that start together, in services of one compose
file, or in nodes of their launch files. Units and the services of a compose file belong together if there is one such
group and one file, and docker starts the services at boot on the network of the host. Also a launch file that overrides
the value that the unit or service gets from another file. Not reported: unknown values, a launch file that gives its
own nodes several values, services that no choice of one compose profile starts together, and processes that bridge
domains.

## Why it matters on a robot
The processes do not see each other. Each part works on its own, and the topics of the other part are silently
missing.

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

## When to ignore it
When the parts are separated on purpose and a bridge that the linter does not recognise connects them.

## References
- https://github.com/hucebot/g1pilot/issues/30
- https://github.com/ros2/ros2cli/issues/1009
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import note
from bringup_lint.api import rule
from bringup_lint.api.environment import Different
from bringup_lint.api.environment import Overridden
from bringup_lint.api.environment import conflicts


@rule(
    "warning",
    symptoms=["no topics", "nodes do not see each other"],
    aliases=["env/set-twice-mismatch", "env/rmw-inconsistent-across-units"],
)
def conflict_between_sources(robot: Robot) -> Iterator[Finding]:
    if not robot.ros.processes:
        return
    for name in ("ROS_DOMAIN_ID", "RMW_IMPLEMENTATION"):
        for conflict in conflicts(robot.ros, name):
            yield _different(name, conflict) if isinstance(conflict, Different) else _overridden(name, conflict)


def _different(name: str, conflict: Different) -> Finding:
    (process, variable), (other, usual) = conflict
    effect = "they do not see each other"
    if name == "RMW_IMPLEMENTATION" and "rmw_zenoh_cpp" not in (variable.text, usual.text):
        effect = "ROS does not support two middlewares in one system, and messages between them can be lost"
    return finding(
        variable.value,
        f"{process.name} has {name}={variable.text}, but {other.name} has {name}={usual.text}: {effect}",
        advice="keep the variable in one environment file that all of them read",
        related=[note(usual.value, f"{other.name} gets its value here")],
    )


def _overridden(name: str, conflict: Overridden) -> Finding:
    (process, variable), hidden, launcher = conflict
    if launcher is not None:
        return finding(
            variable.value,
            f"{process.name} has {name}={variable.text}: launch overrides the {hidden.text} of {launcher.name}",
            advice="keep the variable in one environment file, and do not set it in the launch file",
            related=[note(hidden.value, f"{launcher.name} gets this value")],
        )
    return finding(
        variable.value,
        f"{process.name} has {name}={variable.text}: the shell overrides the {hidden.text} of the unit",
        advice="keep the variable in one place, and do not set it in the script",
        related=[note(hidden.value, "the unit sets this value")],
    )
