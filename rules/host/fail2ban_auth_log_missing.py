"""fail2ban reads a log file that does not exist.

## What it finds
`logpath = /var/log/auth.log` of the enabled jail `[sshd]` without `backend = systemd`, when fstab mounts a tmpfs on
/var/log.

## Why it matters on a robot
The file does not exist when fail2ban starts: `Have not found any log file for sshd jail`, and the service exits.

## Bad
```ini
[sshd]
enabled = true
logpath = /var/log/auth.log
```

## Good
```ini
[sshd]
enabled = true
backend = systemd
```

## When to ignore it
When something creates the file before fail2ban starts, such as rsyslog with an order between the two units.

## References
- jail.conf(5), "backend"
- robotics-security guide
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import note
from bringup_lint.api import rule


@rule("info", symptoms=["Have not found any log file for sshd jail"])
def fail2ban_auth_log_missing(robot: Robot) -> Iterator[Finding]:
    for jail in robot.jails:
        path = jail.get("sshd", "logpath")
        backend = jail.get("sshd", "backend") or jail.get("DEFAULT", "backend")
        if path is None or not path.startswith("/var/log/auth.log") or backend == "systemd":
            continue
        if jail.get("sshd", "enabled") == "false" or len(robot.fstabs) != 1:
            continue
        mount = robot.fstabs[0].mount_of("/var/log/auth.log")
        if mount is not None and mount.is_tmpfs:
            yield finding(
                path,
                f"{path} does not exist when fail2ban starts: {mount.place} is a tmpfs",
                advice="write backend = systemd",
                related=[note(mount.place, "the tmpfs")],
            )
