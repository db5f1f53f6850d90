r"""A line without = in a section: systemd ignores it.

## What it finds
A line inside a section that is not a comment, not an assignment, and not the continuation of the line above.
A line that starts with = is also reported.

## Why it matters on a robot
Usually it is the rest of a command whose first line lacks its backslash: the service starts with half of its
arguments.

## Bad
```ini
[Service]
ExecStart=/usr/bin/robot-drivers
    --port /dev/ttyUSB0
```

## Good
```ini
[Service]
ExecStart=/usr/bin/robot-drivers \
    --port /dev/ttyUSB0
```

## When to ignore it
Never: systemd ignores the line.

## References
- systemd.syntax(7)
- journal: "Missing '=', ignoring line."
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import rule


@rule("error", symptoms=["Missing '=', ignoring line", "Missing key name before '='"])
def missing_equals(robot: Robot) -> Iterator[Finding]:
    for file in robot.units.unit_files:
        if file.source.template:
            continue
        torn = {problem.where.line for problem in file.problems if problem.code == "backslash-blank"}
        for problem in file.problems:
            if problem.code == "missing-equals" and problem.where.line - 1 not in torn:
                yield finding(
                    problem.where,
                    "No '=' in this line: systemd ignores it",
                    advice="write Key=value, or end the line above with a backslash to continue it",
                )
        for assignment in file.assignments:
            if not assignment.key:
                yield finding(
                    assignment.span,
                    "No key before '=': systemd ignores the line",
                    advice="write Key=value",
                )
