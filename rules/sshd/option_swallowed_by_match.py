"""A line for all users belongs to the Match block above it.

## What it finds
A line that is not indented, after a Match block whose own lines are indented.

## Why it matters on a robot
All lines after a Match line belong to its block, up to the next Match, whatever their indentation. The line
that should turn passwords off for everyone applies to one user only.

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

## When to ignore it
When the line is meant for the block. Indent it, so that the next reader sees it.

## References
- sshd_config(5), "Match"
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import note
from bringup_lint.api import rule


@rule("error", silent="the line is valid in the block")
def option_swallowed_by_match(robot: Robot) -> Iterator[Finding]:
    for sshd in robot.sshd:
        for file in sshd.files:
            indented = set()
            refused = {problem.span for problem in file.problems if problem.code == "not-in-match"}
            for option in file.options:
                match = option.match
                if match is None or match.always or option.name == "Match" or option.keyword.span in refused:
                    continue
                if option.keyword.span.column > match.keyword.span.column:
                    indented.add(match.keyword.span)
                elif match.keyword.span in indented:
                    yield finding(
                        option.keyword,
                        f"This line applies only to Match {match.condition}",
                        advice="move it above the first Match, or put Match all before it",
                        related=[note(match.keyword, "the block begins here and ends at the next Match")],
                    )
