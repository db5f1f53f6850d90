"""A keyword that sshd does not know: it refuses to start.

## What it finds
A word at the start of a line that is no keyword of sshd_config.

## Why it matters on a robot
sshd ends with an error at its next start. The session that made the change still works; after the reboot
nobody gets in, and the robot is far away.

## Bad
```
PasswordAuthentification no
```

## Good
```
PasswordAuthentication no
```

## References
- sshd_config(5)
- sshd: "Bad configuration option: PasswordAuthentification"
"""

from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import fix
from bringup_lint.api import nearest
from bringup_lint.api import rule


@rule("error", fix="unsafe", symptoms=["Bad configuration option"])
def unknown_option(robot: Robot):
    for sshd in robot.sshd:
        for file in sshd.files:
            for problem in file.problems:
                if problem.code != "unknown-option":
                    continue
                word = problem.where
                meant = nearest(word, sshd.keywords)
                yield finding(
                    word,
                    f"sshd knows no '{word}' and refuses to start: nobody gets in any more",
                    advice=f"did you mean {meant[0]}?" if meant else "remove the line, and try with sshd -t",
                    fix=fix(f"write {meant[0]}", (word, meant[0]), safe=False) if len(meant) == 1 else None,
                )
