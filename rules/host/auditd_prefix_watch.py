"""An audit watch matches exactly one path.

## What it finds
`-w` with a path that is only the beginning of a name (it ends with `-`, `_` or `.`) or that contains wildcards.

## Why it matters on a robot
auditd supports neither globs nor prefixes. It watches a file that does not exist, and never records changes to the
robot's units.

## Bad
```
-w /etc/systemd/system/robot- -p wa -k robot_services
```

## Good
```
-w /etc/systemd/system/ -p wa -k robot_services
```

## When to ignore it
When a file with exactly this name exists.

## References
- audit.rules(7), auditctl(8), "-w"
- robotics-security guide, audit rules
"""

import re
from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import regex
from bringup_lint.api import rule

WATCH = regex(r"^[ \t]*-w[ \t]+(\S+)", re.M)


@rule("warning", silent="auditd watches the one path without a message")
def auditd_prefix_watch(robot: Robot) -> Iterator[Finding]:
    for source in robot.of_kind("audit-rules"):
        for match in WATCH.finditer(source.text):
            path = source.located(match.start(1), match.end(1))
            if path[-1] in "-_." or set(path) & set("*?["):
                folder = path.rpartition("/")[0] or "/"
                yield finding(
                    path,
                    f"auditd watches exactly '{path}': it supports neither globs nor prefixes",
                    advice=f"watch the folder: -w {folder}/",
                )
