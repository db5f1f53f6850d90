"""systemd ignores lines that start with export.

## What it finds
`export NAME=VALUE` in a file that a unit reads with EnvironmentFile=. Files that only shells read are not reported.

## Why it matters on a robot
systemd reads "export NAME" as the name, which is not valid. When the process starts, it ignores the line, and says so
only once in the journal. The node runs with another domain or RMW than the robot's shells.

## Bad
```sh
export ROS_DOMAIN_ID=42
```

## Good
```sh
ROS_DOMAIN_ID=42
```

## When to ignore it
When the unit's own shell sources the same file, so that the variable reaches the process anyway.

## References
- systemd.exec(5), "EnvironmentFile="
- https://github.com/systemd/systemd/issues/2836
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import fix
from bringup_lint.api import note
from bringup_lint.api import rule


@rule(
    "error",
    fix="unsafe",
    symptoms=["Ignoring invalid environment assignment 'export", "poorly formatted environment: variable 'export"],
)
def export_prefix(robot: Robot) -> Iterator[Finding]:
    for file in robot.env_files:
        sourced = file.sourced_by
        for problem in file.model.problems:
            if problem.code != "export-prefix":
                continue
            name = problem.detail
            start = problem.span.start
            end = file.source.text.index(name, start)
            advice = f"write {name}=... without export"
            if sourced is not None:
                advice += "; the shell that sources the file then needs 'set -a' before it"
            yield finding(
                problem.where,
                f"systemd ignores 'export {name}', with one line in the journal: {name} is not set",
                advice=advice,
                related=[note(file.readers[0].value, "the service reads it here")],
                fix=fix("remove export", (file.source.span(start, end), ""), safe=sourced is None),
            )
