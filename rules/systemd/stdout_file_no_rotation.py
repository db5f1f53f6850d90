"""Output goes to a file that grows forever.

## What it finds
StandardOutput= or StandardError= with `append:` or `file:`, when no logrotate file of the tree covers the
file. In a complete root file system, `logrotate/missing` reports the files that are appended to.

## Why it matters on a robot
ROS nodes log a lot. The small disk of a robot is full after weeks. Then nothing works any more, least of all
the update.

## Bad
```ini
[Service]
StandardOutput=append:/var/log/rover/base.log
```

## Good
```ini
[Service]
StandardOutput=journal
```

## When to ignore it
When the program prints only a few lines per boot, or when a job outside of this tree truncates the file.

## References
- systemd.exec(5), StandardOutput=; logrotate(8)
"""

import re
from collections.abc import Iterator
from fnmatch import fnmatchcase

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import regex
from bringup_lint.api import rule

TO_FILE = regex(r"(?:append|file):(/\S+)$")
PATTERN = regex(r"^[ \t]*[\"']?(/[^\s\"'{]+)", re.M)
SINKS = ("/dev/", "/proc/", "/run/")


@rule("info", symptoms=["No space left on device"])
def stdout_file_no_rotation(robot: Robot) -> Iterator[Finding]:
    told = {log.path for log in robot.logs.uncovered()} if robot.tree.complete else set()
    for unit in robot.units.services:
        seen = set(told)
        for key in ("StandardOutput", "StandardError"):
            value = unit.get(key)
            match = TO_FILE.match(value) if value else None
            if (
                not value
                or not match
                or match[1] in seen
                or match[1].startswith(SINKS)
                or unit.get("Type") == "oneshot"
            ):
                continue
            seen.add(match[1])
            if any(fnmatchcase(match[1], pattern) for pattern in _rotated(robot)) or unit.is_opaque(value):
                continue
            yield finding(
                value,
                f"{match[1]} grows without limit: nothing rotates it",
                advice="use the journal, or ship a logrotate file for it",
            )


def _rotated(robot: Robot) -> Iterator[str]:
    """The patterns of all logrotate files."""
    paths = (path for path in robot.tree.paths if "/logrotate.d/" in path or path.endswith("/logrotate.conf"))
    for source in filter(None, (robot.tree.read(path, judged=False) for path in paths)):
        yield from PATTERN.findall(source.said)
