"""A file named on the command line is of no known kind.

## What it finds
A file that was given by name and that no family recognises by its name or content. Files met while walking a folder are
passed over without a word.

## Why it matters on a robot
A typing mistake in a hook or a CI job would otherwise check nothing and succeed.

## Bad
```
$ bringup-lint robot.servce
```

## Good
```
$ bringup-lint robot.service
```

## References
- the README, "What it reads"
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import rule


@rule("warning")
def unknown_kind(robot: Robot) -> Iterator[Finding]:
    for problem in robot.problems:
        if problem.code == "unknown-kind":
            yield finding(problem.where, "Nothing was checked: this is no kind of file that bringup-lint knows")
