"""A file cannot be read.

## What it finds
A file or folder that cannot be read: no permission, a FIFO or device instead of a file, a file above the size
limit, or a file that disappeared during the run. Also a unit with a line of more than 1 MiB, continuations included:
systemd does not load it either.

## Why it matters on a robot
A file that is not read is not checked: a mistake in it stays hidden.

## Bad
```
$ bringup-lint /etc          # as a user who cannot read netplan's files
```

## Good
```
$ sudo bringup-lint /etc
```

## When to ignore it
When the user of the run deliberately has no access to the file, such as a private key. Check it in a run as root.

## References
- open(2)
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import rule


@rule("error", silent="only bringup-lint reports it")
def unreadable(robot: Robot) -> Iterator[Finding]:
    for problem in robot.problems:
        if problem.code == "unreadable":
            yield finding(problem.where, f"Not checked: {problem.detail}")
    for line in robot.units.endless_lines:
        yield finding(line, "Not checked: this line is longer than 1 MiB, and systemd refuses the whole file")
