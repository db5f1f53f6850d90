"""There are spaces around = in an environment file.

## What it finds
Spaces before or after the `=` of an entry in a file that a unit reads with EnvironmentFile=.

## Why it matters on a robot
systemd accepts the entry, a shell that sources the file runs the name as a command, and docker makes the space part
of the name: the same file means three things.

## Bad
```sh
ROS_DOMAIN_ID = 42
```

## Good
```sh
ROS_DOMAIN_ID=42
```

## When to ignore it
When only systemd ever reads the file.

## References
- systemd.exec(5), "EnvironmentFile="; bash(1), "PARAMETERS"
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import fix
from bringup_lint.api import note
from bringup_lint.api import rule


@rule(
    "warning",
    fix="safe",
    symptoms=[
        "poorly formatted environment: variable * contains whitespaces",
        "ROS_DOMAIN_ID: command not found",
    ],
)
def spaces_around_eq(robot: Robot) -> Iterator[Finding]:
    for file in robot.env_files:
        for entry in file.model.entries:
            blanks = list(file.blanks_around_equals(entry))
            if blanks:
                alone = file.sourced_by is None and file.docker_run is None
                yield finding(
                    entry.name,
                    f"Spaces around the = of {entry.name}: systemd ignores them, but a shell or docker does not",
                    advice="remove the spaces",
                    related=[note(file.readers[0].value, "the service reads it here")],
                    fix=fix("remove the spaces", *((blank, "") for blank in blanks), safe=alone),
                )
