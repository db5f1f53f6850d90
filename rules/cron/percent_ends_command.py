r"""A percent sign ends the command of a job.

## What it finds
A `%` without a backslash before it in the command of a crontab's job, inside of quotes or of `$(...)` or behind a `+`,
most often in `date +%Y%m%d`.

Silent in trees that run BusyBox's crond (Alpine) or supercronic, for which the sign means nothing.

## Why it matters on a robot
cron ends the command at the first `%` and gives the rest to its standard input. The shell gets an unfinished line,
`unexpected EOF`, and the job does nothing: recordings are not packed, and the disk fills up.

## Bad
```
0 3 * * * tar czf /data/backup_$(date +%Y%m%d).tgz /data/bags
```

## Good
```
0 3 * * * tar czf /data/backup_$(date +\%Y\%m\%d).tgz /data/bags
```

## When to ignore it
When the command reads its standard input, and the `%` is meant to begin it.

## References
- crontab(5)
"""

import re
from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import regex
from bringup_lint.api import rule

JOB = regex(r"(?m)^[ \t]*(?:@\w+|[\d*/,~-]+(?:[ \t]+[\w*/,~-]+){4})[ \t]+(?P<command>\S[^\n]*)$")
PERCENT = regex(r"(?<!\\)%(?=[\w-])")

OTHER_CRON = regex(r"^FROM[ \t][^\n]*alpine|\bsupercronic\b|\bbusybox\b", re.M | re.I, "alpine supercronic busybox")
QUOTED = regex(r"'[^']*'|\"[^\"]*\"|`[^`]*`|\$\([^()]*\)")
OPEN = regex(r"[\"'`]|\$\(|\+$")


@rule("error", symptoms=["unexpected EOF while looking for matching", "Syntax error: end of file unexpected"])
def percent_ends_command(robot: Robot) -> Iterator[Finding]:
    if robot.mentions(OTHER_CRON):
        return
    for source in robot.of_kind("cron", "user-crontab"):
        for job in JOB.finditer(source.text):
            found = PERCENT.search(source.text, job.start("command"), job.end("command"))
            if found is None or not source.judged or source.template or "/crontabs/" in source.name:
                continue
            if _is_unfinished(source.text[job.start("command") : found.start()]):
                yield finding(
                    source.located(*found.span()),
                    "cron ends the command at this '%' and gives the rest to its standard input",
                    advice="write \\% for each percent sign",
                )


def _is_unfinished(command: str) -> bool:
    """Whether a command ends inside of quotes or of a substitution, or at the plus of a format."""
    return OPEN.search(QUOTED.sub("", command)) is not None
