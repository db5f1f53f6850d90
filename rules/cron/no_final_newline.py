"""The last line of a crontab does not end with a newline.

## What it finds
A crontab whose last line does not end with a newline.

## Why it matters on a robot
crontab(5) requires it. Debian's cron ignores the whole file (`Missing newline before EOF, this crontab file
will be ignored`).

## Bad
```
0 3 * * * root /opt/robot/clean<EOF>
```

## Good
```
0 3 * * * root /opt/robot/clean\n<EOF>
```

## When to ignore it
Never: a newline does no harm, and without it Debian's cron ignores the file.

## References
- crontab(5)
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import fix
from bringup_lint.api import rule


@rule("error", fix="unsafe", symptoms=["Missing newline before EOF, this crontab file will be ignored"])
def no_final_newline(robot: Robot) -> Iterator[Finding]:
    for source in robot.of_kind("cron"):
        text = source.text
        if not text or text.endswith("\n"):
            continue
        start = text.rfind("\n") + 1
        here = (source.span(len(text), len(text)), "\n")
        yield finding(
            source.span(start, len(text)),
            "The last line has no newline: cron ignores the file",
            advice="end the file with a newline",
            fix=fix("add a newline", here),
        )
