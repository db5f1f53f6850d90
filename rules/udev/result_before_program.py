"""A rule uses the output of a program that has not run.

## What it finds
`RESULT`, `%c` or `$result` where neither the same line nor an earlier one has a `PROGRAM`.

## Why it matters on a robot
The result is empty: the match fails, or the link has no last part and several devices share it.

## Bad
```udev
KERNEL=="ttyUSB*", SYMLINK+="robot/%c"
```

## Good
```udev
KERNEL=="ttyUSB*", PROGRAM="/usr/local/bin/role-of %k", SYMLINK+="robot/%c"
```

## When to ignore it
If a rules file that is not in the tree runs the program earlier, for example one that a vendor package
installs.

## References
- udev(7), PROGRAM and RESULT
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import regex
from bringup_lint.api import rule

_RESULT = regex(r"(?<![%$])(?:%c|\$result)(?![a-z])")


@rule("warning", silent="an empty result is not reported")
def result_before_program(robot: Robot) -> Iterator[Finding]:
    for rules in robot.udev.sets:
        for rule_line in rules.rules:
            if rule_line.line.first("PROGRAM") is not None or rule_line.source.template:
                break
            if not rule_line.judged:
                continue
            for token in rule_line.line.tokens:
                used = None if token.is_match else _RESULT.search(token.value)
                if token.key == "RESULT" or used:
                    yield finding(
                        token.value.part(*used.span()) if used else token.span,
                        "No PROGRAM runs before this line: the result is empty",
                        advice="add PROGRAM= to this line or to an earlier one",
                    )
