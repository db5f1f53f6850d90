"""cron ignores a file by its name.

## What it finds
A file in `/etc/cron.d` whose name holds anything but letters, digits, `_` and `-`.

## Why it matters on a robot
Debian's and Ubuntu's cron passes over `robot.cron` and `rotate.sh` without a word: the job never runs.

## Bad
```
/etc/cron.d/rotate-certs.cron
```

## Good
```
/etc/cron.d/rotate-certs
```

## References
- cron(8), Debian
"""

import re

from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import rule

NAME = re.compile(r"[A-Za-z0-9_-]+")


@rule("error")
def filename_dot(robot: Robot):
    for source in robot.of_kind("cron"):
        if "/cron.d/" in f"/{source.name}" and not NAME.fullmatch(source.basename):
            yield finding(
                source,
                f"cron ignores this file: '{source.basename}' may hold letters, digits, _ and - only",
                advice=f"rename it to {re.sub(r'[^A-Za-z0-9_-]+', '-', source.basename)}",
            )
