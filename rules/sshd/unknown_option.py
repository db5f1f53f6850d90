"""A keyword that sshd does not know: it refuses to start.

## What it finds
A word at the start of a line that is not a keyword of sshd_config.

## Why it matters on a robot
sshd exits with an error at its next start. The session that made the change still works. After the reboot
nobody can log in, and the robot may be far away.

## Bad
```
PasswordAuthentification no
```

## Good
```
PasswordAuthentication no
```

## When to ignore it
Only if the robot's OpenSSH is newer than this tool, or patched, and knows the keyword: `sshd -t` on the robot
shows it.

## References
- sshd_config(5)
- sshd: "Bad configuration option: PasswordAuthentification"
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import rule
from bringup_lint.api.schema import unknown_name
from bringup_lint.api.spelling import nearest


@rule("error", fix="unsafe", symptoms=["Bad configuration option"])
def unknown_option(robot: Robot) -> Iterator[Finding]:
    for sshd in robot.sshd:
        for problem in sshd.problems:
            if problem.code == "unknown-option":
                message = f"sshd does not know '{problem.word}' and refuses to start: nobody can log in"
                near = nearest(problem.word, sshd.keywords)
                yield unknown_name(problem.word, message, near, "remove the line, and test with sshd -t", safe=False)
