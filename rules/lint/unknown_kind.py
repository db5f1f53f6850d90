"""The kind of a file on the command line is unknown.

## What it finds
A file that was given by name but that no family recognises by its name or content. Unknown files in a folder are
skipped silently.

## Why it matters on a robot
A typing error in a hook or a CI job would otherwise check nothing and succeed.

## Bad
```
$ bringup-lint robot.servce
```

## Good
```
$ bringup-lint robot.service
```

## When to ignore it
When a tool such as pre-commit passes a fixed list of files and some of them are not configuration.

## References
- [Rules by kind of file](https://bringup-lint.github.io/bringup-lint/rules/files/)
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import rule


@rule("warning", silent="only bringup-lint reports it")
def unknown_kind(robot: Robot) -> Iterator[Finding]:
    for problem in robot.problems:
        if problem.code == "unknown-kind":
            yield finding(
                problem.where,
                "Nothing was checked: bringup-lint does not read this kind of file",
                advice="name it as on the robot, such as rover.service or udev/rules.d/99-rover.rules, or leave it out",
            )
