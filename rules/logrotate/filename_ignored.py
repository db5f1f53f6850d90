"""logrotate passes over a file with this name.

## What it finds
A file in logrotate.d whose name ends in .bak, ~, .swp, .dpkg-old, .disabled or another ending that
logrotate leaves out.

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

## References
- logrotate(8), "tabooext"
"""

from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import rule


@rule("warning", symptoms=["pattern match"])
def filename_ignored(robot: Robot):
    names = {source.name for source in robot.of_kind("logrotate")}
    for source in robot.of_kind("logrotate-misnamed"):
        stem = source.name.rpartition(".")[0] if "." in source.basename else source.name.rstrip("~")
        if source.judged and stem not in names and stem.rstrip("~") not in names:
            yield finding(
                source,
                f"logrotate passes over {source.basename}: it leaves out names with this ending",
                advice="rename the file, or delete it",
            )
