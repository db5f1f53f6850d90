r"""A line without = in a section is ignored.

## What it finds
A line inside a section that is neither a comment, nor an assignment, nor the continuation of the line
above; also a line that starts with =.

## Why it matters on a robot
Mostly it is the rest of a command whose first line lacks its backslash: the service starts with half of its
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

## References
- systemd.syntax(7)
- journal: "Missing '=', ignoring line."
"""

from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import rule


@rule("error", symptoms=["Missing '=', ignoring line", "Missing key name before '='"])
def missing_equals(robot: Robot):
    for file in robot.units.files:
        if file.source.template:
            continue
        torn = {problem.where.line for problem in file.problems if problem.code == "backslash-blank"}
        for problem in file.problems:
            if problem.code == "missing-equals" and problem.where.line - 1 not in torn:
                yield finding(
                    problem.where,
                    "No '=' in this line: systemd ignores it",
                    advice="write Key=value; to continue the line above, end that one with a backslash",
                )
        for assignment in file.assignments:
            if not assignment.key:
                yield finding(
                    assignment.span,
                    "No key before '=': systemd ignores the line",
                    advice="write Key=value",
                )
