"""A directive that logrotate does not know: it ignores the line.

## What it finds
A word at the start of a line that is not a directive of logrotate.

## Why it matters on a robot
logrotate reports this in a log that nobody reads, ignores the line and exits with status 1. The size or age
that should keep the disk from filling up has no effect.

## Bad
```
/var/log/ros2/*.log {
    rotates 4
}
```

## Good
```
/var/log/ros2/*.log {
    rotate 4
}
```

## When to ignore it
When the robot's logrotate is newer than this tool and knows the directive: `logrotate -d` shows it.

## References
- logrotate(8)
- logrotate: "unknown option 'rotates' -- ignoring line"
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import rule
from bringup_lint.api.schema import unknown_name
from bringup_lint.api.spelling import nearest


@rule("error", fix="unsafe", symptoms=["unknown option", "-- ignoring line"])
def unknown_directive(robot: Robot) -> Iterator[Finding]:
    for file in robot.logs.files:
        for problem in file.problems:
            if problem.code == "unknown-directive":
                message = f"logrotate does not know '{problem.word}': it ignores the line"
                near = nearest(problem.word, robot.logs.directives)
                yield unknown_name(problem.word, message, near, "remove the line, or see logrotate(8)")
