"""An environment variable is set after the nodes that need it.

## What it finds
`SetEnvironmentVariable` (`<set_env>`) of a ROS or DDS variable after the first node of the description.

## Why it matters on a robot
A process gets the environment of the moment in which it starts. Nodes before the line run without the variable.
They use another middleware or domain, and the two halves of the robot do not see each other.

## Bad
```python
LaunchDescription([
    Node(package='demo', executable='driver'),
    SetEnvironmentVariable('RMW_IMPLEMENTATION', 'rmw_cyclonedds_cpp'),
])
```

## Good
```python
LaunchDescription([
    SetEnvironmentVariable('RMW_IMPLEMENTATION', 'rmw_cyclonedds_cpp'),
    Node(package='demo', executable='driver'),
])
```

## When to ignore it
When the earlier nodes are meant to run without the variable, for example a bridge that stays in the default domain.
A scoped group shows that intention better.

## References
- launch, `SetEnvironmentVariable`
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import fix
from bringup_lint.api import launch
from bringup_lint.api import note
from bringup_lint.api import regex
from bringup_lint.api import rule
from bringup_lint.api.python import move_before

PREFIXES = ("ROS_", "RMW_", "CYCLONEDDS_", "FASTRTPS_", "FASTDDS_", "RCUTILS_", "RCL_", "ZENOH_")

LOGS = regex(r"LOG|CONSOLE|COLORIZED")
"""Variables of the logs: without them the nodes run as with them."""


@rule("warning", fix="unsafe", silent="the node starts without the variable")
def env_set_too_late(robot: Robot) -> Iterator[Finding]:
    for file in robot.launch.judged:
        started = None
        for action in file.actions:
            if isinstance(action, launch.Node) and started is None and not action.conditions:
                started = action
            name = launch.literal(action.name) if isinstance(action, launch.SetEnv) else None
            if started is None or name is None or not name.startswith(PREFIXES) or LOGS.search(name):
                continue
            later = file.actions[file.actions.index(action) + 1 :]
            rest = any(
                isinstance(each, (launch.Process, launch.Include, launch.Group)) for each in launch.walk_actions(later)
            )
            what = "the nodes before it run without it" if rest else "no node gets it"
            move = move_before(action.span, started.span)
            yield finding(
                action.span,
                f"{name} is set after nodes have started: {what}",
                advice="set it first in the description",
                fix=fix(f"set {name} before the nodes start", codemod=move, safe=False) if move else None,
                related=[note(started.span, "already started")],
            )
