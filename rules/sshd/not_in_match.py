"""A keyword that may not stand in a Match block: sshd refuses to start.

## What it finds
A keyword that holds for the whole server, such as Port or UsePAM, behind a Match line.

## Why it matters on a robot
Everything behind a Match line belongs to it, up to the next one. sshd ends with an error at its next start,
and after the reboot nobody gets in.

## Bad
```
Match User operator
    X11Forwarding yes

Port 2222
```

## Good
```
Port 2222

Match User operator
    X11Forwarding yes
```

## References
- sshd_config(5), "Match"
- sshd: "Directive 'Port' is not allowed within a Match block"
"""

from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import note
from bringup_lint.api import rule


@rule("error", symptoms=["is not allowed within a Match block"])
def not_in_match(robot: Robot):
    for sshd in robot.sshd:
        for file in sshd.files:
            places = {option.keyword.span: option.match for option in file.options}
            for problem in file.problems:
                if problem.code == "not-in-match":
                    match = places.get(problem.where.span)
                    yield finding(
                        problem.where,
                        f"{problem.where} may not stand in a Match block: sshd refuses to start",
                        advice="move it above the first Match, or put Match all before it",
                        related=[note(match.keyword, "the block begins here")] if match else (),
                    )
