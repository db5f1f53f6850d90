"""An environment file sets an invalid variable name.

## What it finds
An entry of a file that a unit reads with EnvironmentFile= whose name contains other characters than letters, digits
and `_`, or starts with a digit.

## Why it matters on a robot
systemd ignores the entry when the process starts, and says so only once in the journal.

## Bad
```sh
ROS-DOMAIN-ID=42
```

## Good
```sh
ROS_DOMAIN_ID=42
```

## When to ignore it
When only another program reads the entry, such as a script that parses the file itself.

## References
- systemd.exec(5), "EnvironmentFile="; environ(7)
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import note
from bringup_lint.api import rule


@rule("error", symptoms=["Ignoring invalid environment assignment"])
def bad_name(robot: Robot) -> Iterator[Finding]:
    for file in robot.env_files:
        for problem in file.model.problems:
            name = problem.where
            if problem.code != "bad-name" or file.source.template:
                continue
            shown = f"'{name}'" if len(name) <= 40 else f"'{name[:37]}...'"
            yield finding(
                name if name else problem.where,
                f"{shown} is not the name of a variable: systemd ignores the entry",
                advice="use only letters, digits and _, and no digit at the start",
                related=[note(file.readers[0].value, "the service reads it here")],
            )
