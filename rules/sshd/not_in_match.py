"""A keyword that is not allowed in a Match block: sshd refuses to start.

## What it finds
A keyword for the whole server, such as Port or UsePAM, after a Match line.

## Why it matters on a robot
All lines after a Match line belong to its block, up to the next Match. sshd exits with an error at its next
start. After the reboot nobody can log in.

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

## When to ignore it
Only if the robot's OpenSSH is newer than this tool and allows the keyword there: `sshd -t` on the robot shows
it.

## References
- sshd_config(5), "Match"
- sshd: "Directive 'Port' is not allowed within a Match block"
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import note
from bringup_lint.api import rule


@rule("error", symptoms=["is not allowed within a Match block"])
def not_in_match(robot: Robot) -> Iterator[Finding]:
    for sshd in robot.sshd:
        for file in sshd.files:
            places = {option.keyword.span: option.match for option in file.options}
            for problem in file.problems:
                if problem.code == "not-in-match":
                    match = places.get(problem.span)
                    yield finding(
                        problem.where,
                        f"{problem.where} is not allowed in a Match block: sshd refuses to start",
                        advice="move it above the first Match, or put Match all before it",
                        related=[note(match.keyword, "the block begins here")] if match else (),
                    )
