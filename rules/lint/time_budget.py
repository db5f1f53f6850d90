"""A file or a rule takes more time than it may.

## What it finds
A file that is not parsed within 120 seconds of CPU time (C++ sources: within a number of steps that grows with the
file), a rule that does not end within 300, and rules that did not run because all rules together took more than 1,200.

## Why it matters on a robot
No real configuration comes near. A file that does is generated, damaged or made to keep a check busy, and what it would
do to the programs that read it at boot is not known. The report lacks the findings on it.

## Bad
```
$ ls -l /etc/udev/rules.d/99-robot.rules
-rw-r--r-- 1 root root 8388001 Jul  1 12:00 /etc/udev/rules.d/99-robot.rules
```

## Good
```
$ ls -l /etc/udev/rules.d/99-robot.rules
-rw-r--r-- 1 root root 412 Jul  1 12:00 /etc/udev/rules.d/99-robot.rules
```

## When to ignore it
Never: exclude the file, or report the defect when the file is an ordinary one.

## References
- setitimer(2), "ITIMER_PROF"
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import rule


@rule("error", silent="only bringup-lint reports it")
def time_budget(robot: Robot) -> Iterator[Finding]:
    """Reported by the engine."""
    return iter(())
