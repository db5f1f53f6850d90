"""Two stanzas name the same log: logrotate rejects the second.

## What it finds
The same path in two stanzas of a file, or in two files of /etc/logrotate.d. Stanzas after one with
`ignoreduplicates` are exempt.

## Why it matters on a robot
logrotate drops the second stanza with all its settings and exits with status 1: the timer unit shows as
failed.

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

## When to ignore it
When the two files never end up on the same robot, for example because they belong to alternative packages.

## References
- logrotate(8), "ignoreduplicates"
- logrotate: "duplicate log entry for ..."
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Located
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import note
from bringup_lint.api import rule


@rule("error", symptoms=["duplicate log entry for"])
def duplicate_path(robot: Robot) -> Iterator[Finding]:
    for files in robot.logs.by_folder.values():
        known: dict[str, Located] = {}
        for file in files:
            for stanza in file.stanzas:
                for path in stanza.paths:
                    first = known.get(path)
                    if first is not None and not stanza.skipped:
                        yield finding(
                            path,
                            f"{path} already has a stanza: logrotate drops this one",
                            advice="keep one of the two",
                            related=[note(first, "the first stanza")],
                        )
                    if not stanza.skipped and not stanza.get("ignoreduplicates"):
                        known.setdefault(path, path)
