"""A file cannot be read.

## What it finds
A file or folder that was named or met and cannot be read: no permission, a FIFO or device in the place of a file, a
file beyond the size limit, a file that vanished during the run.

## Why it matters on a robot
What is not read is not checked: a mistake in it stays unseen.

## Bad
```
$ chmod 000 /etc/systemd/system/robot.service
```

## Good
```
$ chmod 644 /etc/systemd/system/robot.service
```

## References
- open(2)
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import rule


@rule("error")
def unreadable(robot: Robot) -> Iterator[Finding]:
    for problem in robot.problems:
        if problem.code == "unreadable":
            yield finding(problem.where, f"Not checked: {problem.detail}")
