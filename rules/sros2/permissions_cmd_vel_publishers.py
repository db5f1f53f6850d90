"""Several enclaves may publish the same velocity command.

## What it finds
More than one enclave with an explicit right to publish the same velocity topic, in a tree whose launch files
do not mention a multiplexer, smoother, collision monitor or gate. Enclaves of programs that forward what others
publish, such as a bridge or a relay, are not counted, by their names.

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
from bringup_lint.api import regex
from bringup_lint.api import rule

FORWARDS = regex(r"bridge|mux|relay|gate|smoother|collision|arbiter|filter|proxy")


@rule("warning", silent="nothing is refused, so nothing is reported")
def permissions_cmd_vel_publishers(robot: Robot) -> Iterator[Finding]:
    if any(robot.sros2.in_launch(word) for word in ("mux", "collision_monitor", "smoother", "gate", "arbiter")):
        return
    publishers: dict[str, dict[str, Located]] = {}
    for _, grant in robot.sros2.ros_grants:
        if FORWARDS.search(str(grant.enclave)):
            continue
        for topic in (topic for rule_ in grant.allowed for topic in rule_.publish):
            if re.fullmatch(r"rt/(?:[\w/]+/)?cmd_vel(?:_\w+)?", topic):
                publishers.setdefault(str(topic), {}).setdefault(str(grant.enclave), topic)
    together: dict[tuple[str, ...], list[Located]] = {}
    for enclaves in publishers.values():
        together.setdefault(tuple(enclaves), []).extend(enclaves.values())
    for names, places in together.items():
        if len(names) < 2:
            continue
        commands = list(dict.fromkeys(str(each) for each in places))
        what = commands[0] if len(commands) == 1 else f"{commands[0]} and {len(commands) - 1} more"
        yield finding(
            places[1],
            f"{' and '.join(names)} may both publish {what}: their commands conflict, and both drive the robot",
            advice="give each source its own input topic, and only one gate the right to publish the command",
            related=[note(each, "and this one") for each in places if each is not places[1]],
        )
