"""The output of a process goes to a pipe that nobody reads.

## What it finds
`subprocess.Popen` of `ros2 run` or `ros2 launch` with `stdout=PIPE` or `stderr=PIPE`, in a file that reads neither
while the process runs: no `communicate()`, no `.stdout`. A `communicate()` after `poll()` says that the process has
ended comes too late.

## Why it matters on a robot
A pipe holds 64 KiB. Then the process blocks in the middle of a log line, and all its threads that log with it: the
driver sends nothing more. That happens minutes or hours after the start, the sooner the more is going wrong, and the
process still seems to run.

## Bad
```python
self.lidar = subprocess.Popen(['ros2', 'run', 'lidar', 'driver'], stdout=subprocess.PIPE)
```

## Good
```python
self.lidar = subprocess.Popen(['ros2', 'run', 'lidar', 'driver'], stdout=subprocess.DEVNULL)
```

## When to ignore it
When a thread of another file reads the pipe, or when the process surely ends after a few lines.

## References
- https://docs.python.org/3/library/subprocess.html, Popen.wait
- pipe(7), "Pipe capacity"
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import nodes
from bringup_lint.api import rule


@rule("warning", silent="the process waits in its next write without a message")
def pipe_unread(robot: Robot) -> Iterator[Finding]:
    for file in robot.nodes.robot_sources:
        for found in nodes.unread_pipes(robot.nodes.syntax(file)):
            streams = " and ".join(found.streams)
            yield finding(
                file.span_of(found.call),
                f"Nothing reads the {streams} of '{found.command}': it blocks after 64 KiB of output",
                advice="leave the output to the log of this node, or send it to subprocess.DEVNULL or to a file",
                severity=robot.nodes.lowered(file.source, "warning"),
            )
