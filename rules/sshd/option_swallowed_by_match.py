"""A line that was meant for everyone belongs to the Match block above it.

## What it finds
A line at the left margin behind a Match block whose own lines are indented.

## Why it matters on a robot
Everything behind a Match line belongs to it, whatever the indentation, up to the next Match. The line that
turns passwords off holds for one user only.

## Bad
```
Match User operator
    X11Forwarding yes
PasswordAuthentication no
```

## Good
```
PasswordAuthentication no
Match User operator
    X11Forwarding yes
```

## References
- sshd_config(5), "Match"
"""

from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import note
from bringup_lint.api import rule


@rule("error")
def option_swallowed_by_match(robot: Robot):
    for sshd in robot.sshd:
        for file in sshd.files:
            indented = set()
            for option in file.options:
                match = option.match
                if match is None or match.always or option.name == "Match":
                    continue
                if option.keyword.span.column > match.keyword.span.column:
                    indented.add(match.keyword.span)
                elif match.keyword.span in indented:
                    yield finding(
                        option.keyword,
                        f"This line holds for Match {match.condition} only",
                        advice="move it above the first Match, or put Match all before it",
                        related=[note(match.keyword, "the block begins here and ends at the next Match")],
                    )
