"""cron ignores a file because of its name.

## What it finds
A file in `/etc/cron.d` whose name contains a character other than letters, digits, `_` and `-`.

## Why it matters on a robot
The cron of Debian and Ubuntu silently skips `robot.cron` and `rotate.sh`: the job never runs.

## Bad
```
/etc/cron.d/rotate-certs.cron
```

## Good
```
/etc/cron.d/rotate-certs
```

## When to ignore it
When the robot runs cronie or another cron that accepts such names, or when the file was disabled by its name
on purpose.

## References
- cron(8), Debian
"""

import re
from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import regex
from bringup_lint.api import rule
from bringup_lint.api.templates import final_name

NAME = regex(r"[A-Za-z0-9_-]+")


@rule("error", silent="cron skips the file without a message")
def filename_dot(robot: Robot) -> Iterator[Finding]:
    for source in robot.of_kind("cron"):
        name = final_name(source.basename)
        if "/cron.d/" in f"/{source.name}" and not NAME.fullmatch(name):
            yield finding(
                source,
                f"cron ignores '{name}': the name may contain only letters, digits, _ and -",
                advice=f"rename it to {re.sub(r'[^A-Za-z0-9_-]+', '-', name)}",
            )
