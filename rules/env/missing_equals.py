"""A line of an environment file is not an assignment.

## What it finds
A line without `=` in a file that a unit reads with EnvironmentFile=, such as `source`, `set -a` or a bare name.
Empty lines, comments and parts of a quoted value are not reported.

## Why it matters on a robot
systemd ignores the line without a message. A `source` line does not load the variables of the other file.

## Bad
```sh
source /opt/ros/jazzy/setup.bash
ROS_DOMAIN_ID=42
```

## Good
```sh
ROS_DOMAIN_ID=42
```

## When to ignore it
When a shell also sources the file and needs the line, and systemd may ignore it.

## References
- systemd.exec(5), "EnvironmentFile="
- https://github.com/systemd/systemd/issues/2836
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import note
from bringup_lint.api import rule


@rule("error", symptoms=["unexpected character * in variable name"])
def missing_equals(robot: Robot) -> Iterator[Finding]:
    for file in robot.env_files:
        for problem in file.model.problems:
            if problem.code != "missing-equals" or file.source.template:
                continue
            word = problem.word.split(maxsplit=1)[0] if problem.word.strip() else ""
            what = (
                "and systemd is not a shell"
                if word in ("source", ".", "set", "export", "if", "fi", "unset")
                else "because it has no ="
            )
            yield finding(
                problem.where,
                f"This line is not an assignment, {what}: systemd ignores it without a message",
                advice="write NAME=VALUE, or remove the line",
                related=[note(file.readers[0].value, "the service reads it here")],
            )
