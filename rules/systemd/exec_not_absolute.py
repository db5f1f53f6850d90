"""The program of an Exec line is neither an absolute path nor a bare name.

## What it finds
A first word such as ./start.sh, ~/start.sh, $HOME/start.sh or scripts/start.sh, or a path that ends in a
slash. A bare name is valid here, because systemd searches it in the system's folders.

## Why it matters on a robot
The unit does not load: systemctl start fails with "bad unit file setting". When systemd reads the path of the
program, it knows no working directory, home or variables.

## Bad
```ini
[Service]
WorkingDirectory=/opt/robot
ExecStart=./start.sh
```

## Good
```ini
[Service]
WorkingDirectory=/opt/robot
ExecStart=/opt/robot/start.sh
```

## When to ignore it
Never: systemd does not load the unit.

## References
- systemd.service(5), "Command lines"
- journal: "Neither a valid executable name nor an absolute path"
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import rule


@rule(
    "error",
    symptoms=[
        "Neither a valid executable name nor an absolute path",
        "has a bad unit file setting",
        "Executable path is not absolute, ignoring:",
    ],
)
def exec_not_absolute(robot: Robot) -> Iterator[Finding]:
    for line in robot.units.wrong_lines:
        if line.directive.type != "command" or line.value == ".":
            continue
        for problem in line.problems:
            word = problem.where
            if problem.code not in ("not-absolute", "bad-program", "empty-command") or word == ".":
                continue
            if line.file.source.template and "$" in word:
                continue
            what = "is not an absolute path" if problem.code == "not-absolute" else f"is not {problem.expected}"
            what = "is a folder" if word.endswith("/") else what
            yield finding(
                word,
                f"'{word}' {what}: {line.consequence(problem)}",
                advice="write the full path of the program; systemd expands neither variables nor ~ in it",
            )
