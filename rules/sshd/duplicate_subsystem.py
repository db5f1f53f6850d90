"""A subsystem is defined twice: sshd refuses to start.

## What it finds
The same Subsystem twice, in one file or in the main file and a drop-in.

## Why it matters on a robot
sshd exits with an error at its next start. After the reboot nobody can log in.

## Bad
```
Subsystem sftp internal-sftp
Subsystem sftp /usr/lib/openssh/sftp-server
```

## Good
```
Subsystem sftp internal-sftp
```

## When to ignore it
Never for files that are installed together. Ignore it when one of them replaces the other on the robot.

## References
- sshd_config(5), "Subsystem"
- sshd: "Subsystem 'sftp' already defined."
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Located
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import note
from bringup_lint.api import rule


@rule("error", symptoms=["already defined"])
def duplicate_subsystem(robot: Robot) -> Iterator[Finding]:
    for sshd in robot.sshd:
        known: dict[str, Located] = {}
        for option in sshd.all("Subsystem"):
            first = known.setdefault(str(option.value), option.value)
            if first is not option.value and option.span.source.judged:
                yield finding(
                    option.value,
                    f"The subsystem {option.value} is already defined: sshd refuses to start",
                    advice="keep one of the two",
                    related=[note(first, "defined here first")],
                )
