"""Real-time limits that apply only to logins, not to the service.

## What it finds
/etc/security/limits.conf or limits.d grants rtprio, memlock or nice to the user of a ROS service, or to a
group of that user, but the unit has no LimitRTPRIO=, LimitMEMLOCK= or LimitNICE=. PAM reads these files at
login. systemd does not read them.

- error: the service runs ros2_control;
- warning: other ROS services;
- info: only nice is granted, and the unit sets Nice=, which systemd applies itself;
- info: the service sets no priority, while another service of the same user does.

## Why it matters on a robot
Started by hand in an SSH session, the control loop gets its priority. As a service it does not, and nobody
reads the one line in the log. The arm jitters only in production.

## Bad
```ini
# limits.d/rover.conf:  rover - rtprio 98
[Service]
User=rover
ExecStart=/bin/bash -c 'source /opt/ros/jazzy/setup.bash && exec ros2 launch rover arm.launch.py'
```

## Good
```ini
[Service]
User=rover
LimitRTPRIO=98
LimitMEMLOCK=infinity
ExecStart=/bin/bash -c 'source /opt/ros/jazzy/setup.bash && exec ros2 launch rover arm.launch.py'
```

## When to ignore it
When the limits are meant only for people who log in, and the nodes of this service need no real-time priority
or locked memory.

## References
- systemd.exec(5), "Process Properties"; limits.conf(5), pam_limits(8)
- <https://github.com/systemd/systemd/issues/27893>
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import fix
from bringup_lint.api import note
from bringup_lint.api import regex
from bringup_lint.api import rule
from bringup_lint.api.systemd import Unit
from bringup_lint.api.systemd import limit_line
from bringup_lint.api.systemd import missing_limits
from bringup_lint.api.systemd import sets_priority

CONTROL = regex(r"ros2_control_node|controller_manager|ros2_control", hints="ros2_control controller_manager")


@rule(
    "warning",
    fix="unsafe",
    symptoms=[
        "Could not enable FIFO RT scheduling policy",
        "Could not enable FIFO RT scheduling policy: with error number <*>(Operation not permitted)",
        "unable to set realtime scheduling: Operation not permitted",
        "Your system/user seems not to be setup for FIFO scheduling",
    ],
)
def rt_limits_only_in_pam(robot: Robot) -> Iterator[Finding]:
    users = {unit.identity.name for unit in robot.units.ros if sets_priority(unit) or _controls(robot, unit)}
    for unit in robot.units.ros:
        if not unit.complete or unit.get("PAMName") or robot.units.supervision(unit).in_container:
            continue
        missing = missing_limits(unit, robot.units)
        if not missing:
            continue
        lines = [limit_line(item, grants[-1]) for item, grants in missing.items()]
        yield finding(
            unit.identity.user or unit.where,
            f"limits.d grants {', '.join(missing)} only to logins: {unit.name} runs without it",
            advice=f"set {' and '.join(lines)} in the unit",
            related=[note(grant.line, "PAM reads this at login") for grants in missing.values() for grant in grants],
            fix=fix("set the limit in the unit", unit.new_line("Service", "\n".join(lines)), safe=False)
            if unit.editable
            else None,
            severity=_severity(robot, unit, set(missing), unit.identity.name in users),
        )


def _severity(robot: Robot, unit: Unit, missing: set[str], another_cares: bool) -> str:
    """``another_cares``: a service of the same user has to do with real time."""
    if missing == {"nice"} and unit.get("Nice"):
        return "info"
    if _controls(robot, unit):
        return "error"
    return "info" if another_cares and not sets_priority(unit) else "warning"


def _controls(robot: Robot, unit: Unit) -> bool:
    return any(CONTROL.search(text) for process in robot.units.started(unit) for text in process.texts)
