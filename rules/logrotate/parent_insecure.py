"""logrotate skips logs in a folder that others may write to.

## What it finds
A stanza without `su` for logs in one of these folders:

- a folder that tmpfiles.d makes writable for group or others;
- /var/log on a tmpfs without `mode=`.

## Why it matters on a robot
logrotate reports "insecure permissions" and rotates nothing there. The logs grow until the disk is full.

## Bad
```ini
# tmpfiles.d
d /var/log/ros2 0775 robot robot -
# logrotate.d
/var/log/ros2/*.log {
    weekly
}
```

## Good
```ini
/var/log/ros2/*.log {
    su robot robot
    weekly
}
```

## When to ignore it
When a provisioning step that is not in this tree tightens the permissions of the folder before logrotate
runs.

## References
- logrotate(8), "su"
- logrotate: "parent directory has insecure permissions"
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import note
from bringup_lint.api import rule


@rule("error", symptoms=["because parent directory has insecure permissions"], tags=["CWE-732"])
def parent_insecure(robot: Robot) -> Iterator[Finding]:
    for stanza in robot.logs.stanzas:
        if stanza.get("su") or stanza.skipped:
            continue
        told = set()
        for path in stanza.paths:
            folder = path.rpartition("/")[0]
            found = robot.logs.open_folder(folder)
            if found is None or folder in told:
                continue
            told.add(folder)
            where, why, owner = found
            yield finding(
                path,
                f"{folder} is not writable by root alone: logrotate skips these logs",
                advice=f"add su {owner}" if owner else "mount it with mode=0755",
                related=[note(where, why)],
            )
