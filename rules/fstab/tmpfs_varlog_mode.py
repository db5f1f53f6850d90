"""Everyone can write to the tmpfs on /var/log.

## What it finds
A tmpfs on `/var/log` without `mode=`. The default is 1777.

## Why it matters on a robot
logrotate refuses to rotate logs in a directory to which others can write (`insecure permissions`), and every user
can place files there.

## Bad
```
tmpfs /var/log tmpfs size=128M 0 0
```

## Good
```
tmpfs /var/log tmpfs size=128M,mode=0755 0 0
```

## When to ignore it
When a unit sets the mode of /var/log after the mount and before logrotate runs.

## References
- tmpfs(5), "mode"
- verified with logrotate 3.21
- robotics-security guide, read-only root
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import fix
from bringup_lint.api import rule


@rule("warning", fix="unsafe", symptoms=["because parent directory has insecure permissions"], tags=["CWE-732"])
def tmpfs_varlog_mode(robot: Robot) -> Iterator[Finding]:
    for fstab in robot.fstabs:
        for mount in fstab.mounts:
            end = mount.end_of_options
            if mount.is_tmpfs and mount.place.rstrip("/") == "/var/log" and not mount.has("mode") and end is not None:
                yield finding(
                    mount.place,
                    "/var/log has mode 1777: everyone can write there, and logrotate refuses to rotate",
                    advice="add mode=0755",
                    fix=fix("add mode=0755", (end, ",mode=0755")),
                )
