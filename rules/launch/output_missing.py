"""The output of a node goes only to a file.

## What it finds
Nodes without `output=`, in files that do not mention `OVERRIDE_LAUNCH_PROCESS_OUTPUT`.

## Why it matters on a robot
The node's standard output goes to a log file below ROS_LOG_DIR. It does not reach the journal, where people look
first.

## Bad
```python
Node(package='demo', executable='talker')
```

## Good
```python
Node(package='demo', executable='talker', output='screen')
```

## When to ignore it
When the node prints too much for the journal, or when the environment of the service sets
`OVERRIDE_LAUNCH_PROCESS_OUTPUT`.

## References
- launch, `OVERRIDE_LAUNCH_PROCESS_OUTPUT`
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import fix
from bringup_lint.api import launch
from bringup_lint.api import rule

OVERRIDE = "OVERRIDE_LAUNCH_PROCESS_OUTPUT"


@rule("info", fix="unsafe", silent="the output is in a file of the log folder")
def output_missing(robot: Robot) -> Iterator[Finding]:
    for file in robot.launch.judged:
        for action, _ in robot.launch.visited(file):
            if (
                not isinstance(action, launch.Node)
                or action.open
                or "output" in action.options
                or OVERRIDE in file.source.said
            ):
                continue
            if launch.literal(action.executable) == "spawner":
                continue
            end = action.executable.span if action.executable is not None else None
            plain = end is not None and end.source is file.source and action.span.start < end.start <= action.span.end
            repair = None
            if end is not None and plain and file.format == "python" and end.text[:1] in "'\"":
                repair = fix("print to the screen", (end.source.span(end.end, end.end), ", output='screen'"))
            elif end is not None and plain and file.format == "xml":
                repair = fix("print to the screen", (end.source.span(end.end + 1, end.end + 1), ' output="screen"'))
            yield finding(
                action.span,
                "The node's output goes only to a file, not to the journal",
                advice="set output='screen'",
                fix=repair,
            )
