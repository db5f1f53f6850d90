"""When the user's last session ends, logind deletes the shared memory of ROS.

## What it finds
A service that runs ROS with shared memory as a regular user who can log in, where logind.conf does not set
`RemoveIPC=no`. Exempt are system users (UID below 1000), users with lingering, and services that use only UDP
or a middleware other than Fast DDS.

It is a warning when logind.conf sets RemoveIPC or the tree is a complete root file system, and an info
otherwise.

## Why it matters on a robot
Someone logs in over SSH for maintenance and logs out. Ten seconds later logind removes all of the user's
files in /dev/shm: Fast DDS goes silent between nodes that are still running.

## Bad
```ini
# robot.service
[Service]
User=robot
```

## Good
```ini
# /etc/systemd/logind.conf.d/robot.conf
[Login]
RemoveIPC=no
```

## When to ignore it
When nobody ever logs in as this user, or when lingering is enabled for the user during provisioning
(`loginctl enable-linger`).

## References
- logind.conf(5), "RemoveIPC="
- <https://github.com/eProsima/Fast-DDS/issues/5576>
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import fix
from bringup_lint.api import note
from bringup_lint.api import rule
from bringup_lint.api.systemd import Unit


@rule("warning", fix="unsafe", symptoms=["Failed init_port fastrtps_port", "open_and_lock_file failed"])
def removeipc(robot: Robot) -> Iterator[Finding]:
    daemon = robot.logind[0] if len(robot.logind) == 1 else None
    setting = daemon.flag("RemoveIPC") if daemon else None
    if len(robot.logind) > 1 or (setting and not setting[1]) or (daemon and not daemon.certain):
        return
    proven = setting is not None or robot.tree.complete
    told = set()
    for unit in robot.units.ros:
        user = unit.get("User")
        if user is None or user in told or unit.manager == "user" or unit.uncertain or unit.is_opaque(user):
            continue
        home = robot.accounts.login_home(user)
        if home is None or uses_no_shared_memory(robot, unit) or robot.tree.has(f"/var/lib/systemd/linger/{user}"):
            continue
        told.add(str(user))
        yield finding(
            user,
            f"When the last session of {user} ends, logind deletes the shared memory of {unit.name}: DDS goes silent",
            advice="set RemoveIPC=no in [Login] in a drop-in in /etc/systemd/logind.conf.d, or use a system user",
            related=[note(setting[0], "enabled here")] if setting else (),
            fix=fix("set RemoveIPC=no", (setting[0], "no"), safe=False) if setting else None,
            severity=None if proven else "info",
            confidence="high" if proven else "medium",
        )


def uses_no_shared_memory(robot: Robot, unit: Unit) -> bool:
    environment = robot.units.environment(unit)
    transports = environment.text("FASTDDS_BUILTIN_TRANSPORTS")
    rmw = environment.text("RMW_IMPLEMENTATION")
    return transports == "UDPv4" or (rmw is not None and "fast" not in rmw)
