"""A drop-in gives the managers of all users to one user.

## What it finds
`User=` in a drop-in or a copy of `user@.service`, other than `User=%i`, where no file of the tree sets this afterwards.
Drop-ins of one user's manager, as `user@1000.service`, are not judged.

## Why it matters on a robot
`user@.service` starts the manager of each user who logs in, with all of that user's services. With `User=root` they
run as root, whoever the user is: what somebody may write into `~/.config/systemd/user` is then a way to root. With
another name, the managers of all users act for that one. Resources need no other user: `CPUWeight=`, `LimitRTPRIO=` and
commands with the prefix `+` are set up by the manager of the system.

## Bad
```ini
# /etc/systemd/system/user@.service.d/realtime.conf
[Service]
User=root
ExecStartPost=/usr/local/sbin/give-realtime
```

## Good
```ini
# /etc/systemd/system/user@.service.d/realtime.conf
[Service]
ExecStartPost=+/usr/local/sbin/give-realtime
```

## When to ignore it
Never.

## References
- user@.service(5)
- systemd.service(5), "Command lines": the prefix `+`
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import rule

MANAGER = "user@.service"
OF_INSTANCE = ("", "%i", "%I")


@rule("error", tags=["CWE-250"], silent="systemd starts the manager as the user that it is told")
def user_manager_as_root(robot: Robot) -> Iterator[Finding]:
    managers = [file for file in robot.units.unit_files if file.name == MANAGER]
    settings = [[each for each in file.assignments if each.key == "User"] for file in managers]
    last = [each[-1] for each in settings if each]  # of each file
    if any(each.opaque or each.value in OF_INSTANCE for each in last):
        return
    for each in last:
        yield finding(
            each.value,
            f"{MANAGER} is the manager of every user: all of them, with their services, run as {each.value}",
            advice="remove User=, and give commands that need root the prefix +",
        )
