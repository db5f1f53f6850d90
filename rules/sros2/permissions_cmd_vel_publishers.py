"""Several enclaves may publish the same velocity command.

## What it finds
More than one enclave with an explicit right to publish the same velocity topic, in a tree whose launch files
do not mention a multiplexer, smoother, collision monitor or gate.

## Why it matters on a robot
Two sources of commands conflict, and a single compromised one drives the robot.

## Bad
```text
enclaves/lawn/teleop/permissions.xml       publish rt/cmd_vel
enclaves/lawn/navigation/permissions.xml   publish rt/cmd_vel
```

## Good
```text
enclaves/lawn/teleop/permissions.xml       publish rt/teleop/cmd_vel
enclaves/lawn/navigation/permissions.xml   publish rt/nav/cmd_vel
enclaves/lawn/gate/permissions.xml         publish rt/cmd_vel
```

## When to ignore it
If only one of the processes runs at a time, for example teleoperation and navigation in separate modes, or a
multiplexer is started in another way than by a launch file.

## References
- twist_mux, nav2_collision_monitor
"""

import re
from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Located
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import note
from bringup_lint.api import rule


@rule("warning")
def permissions_cmd_vel_publishers(robot: Robot) -> Iterator[Finding]:
    if any(robot.sros2.in_launch(word) for word in ("mux", "collision_monitor", "smoother", "gate", "arbiter")):
        return
    publishers: dict[str, dict[str, Located]] = {}
    for _, grant in robot.sros2.ros_grants:
        for rule_ in grant.allowed:
            for topic in rule_.publish:
                if re.fullmatch(r"rt/(?:[\w/]+/)?cmd_vel(?:_\w+)?", topic):
                    publishers.setdefault(str(topic), {}).setdefault(str(grant.enclave), topic)
    for name, enclaves in publishers.items():
        if len(enclaves) > 1:
            first, *others = enclaves.values()
            yield finding(
                others[0],
                f"{' and '.join(enclaves)} may both publish {name}: their commands conflict, and both drive the robot",
                advice="give each source its own input topic, and only one gate the right to publish the command",
                related=[note(each, "and this one") for each in (first, *others[1:])],
            )
