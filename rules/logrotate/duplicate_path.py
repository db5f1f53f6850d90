"""A log stands in two stanzas: logrotate refuses the second.

## What it finds
The same path in two stanzas of a file, or in two files of /etc/logrotate.d. Stanzas with ignoreduplicates
are left alone.

## Why it matters on a robot
logrotate drops the second entry, with what it says, and ends with status 1; the timer shows as failed.

## Bad
```
/var/log/ros2/drivers.log {
    weekly
}
/var/log/ros2/drivers.log {
    daily
}
```

## Good
```
/var/log/ros2/drivers.log {
    daily
}
```

## References
- logrotate(8), "ignoreduplicates"
- logrotate: "duplicate log entry for ..."
"""

from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import note
from bringup_lint.api import rule


@rule("error", symptoms=["duplicate log entry for"])
def duplicate_path(robot: Robot):
    for files in robot.logs.by_folder.values():
        known = {}
        for file in files:
            for stanza in file.stanzas:
                for path in stanza.paths:
                    first = known.get(path)
                    if first is not None and not stanza.skipped:
                        yield finding(
                            path,
                            f"{path} already has a stanza: logrotate drops this one for it",
                            advice="keep one of the two",
                            related=[note(first, "it is rotated here")],
                        )
                    if not stanza.skipped and not stanza.get("ignoreduplicates"):
                        known.setdefault(path, path)
