"""A directive that logrotate does not know: the line is ignored.

## What it finds
A word at the start of a line that is no directive of logrotate.

## Why it matters on a robot
logrotate complains in a log that nobody reads, leaves the line out and ends with status 1: the size or age
that should keep the disk from filling up does not count.

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

## References
- logrotate(8)
- logrotate: "unknown option 'rotates' -- ignoring line"
"""

from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import fix
from bringup_lint.api import nearest
from bringup_lint.api import rule


@rule("error", fix="safe", symptoms=["unknown option", "-- ignoring line"])
def unknown_directive(robot: Robot):
    for file in robot.logs.files:
        for problem in file.problems:
            if problem.code != "unknown-directive":
                continue
            word = problem.where
            meant = nearest(word, robot.logs.directives)
            yield finding(
                word,
                f"logrotate knows no '{word}': it ignores the line",
                advice=f"did you mean {meant[0]}?" if meant else "remove the line, or see logrotate(8)",
                fix=fix(f"write {meant[0]}", (word, meant[0])) if len(meant) == 1 else None,
            )
