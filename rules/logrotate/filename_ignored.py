"""logrotate skips a file with this name.

## What it finds
A file in logrotate.d whose name ends in .bak, ~, .swp, .dpkg-old, .disabled or another ending that logrotate
skips. A copy next to the file that it was copied from is exempt.

## Why it matters on a robot
logrotate does not read the file and says so only in its debug output. The logs grow until the disk is full.

## Bad
```
/etc/logrotate.d/robot.bak
```

## Good
```
/etc/logrotate.d/robot
```

## When to ignore it
When the file was disabled on purpose by renaming it.

## References
- logrotate(8), "tabooext"
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import rule


@rule("warning", symptoms=["Ignoring *, because of * pattern match"])
def filename_ignored(robot: Robot) -> Iterator[Finding]:
    names = {source.name for source in robot.of_kind("logrotate")}
    for source in robot.of_kind("logrotate-misnamed"):
        stem = source.name.rpartition(".")[0] if "." in source.basename else source.name.rstrip("~")
        if source.judged and stem not in names and stem.rstrip("~") not in names:
            yield finding(
                source,
                f"logrotate skips {source.basename} because of the ending of its name",
                advice="rename the file, or delete it",
            )
