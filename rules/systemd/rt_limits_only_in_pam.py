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

import re
from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import fix
from bringup_lint.api import note
from bringup_lint.api import rule
from bringup_lint.api.systemd import Unit
from bringup_lint.api.systemd import granted_limits

SETTING = {"rtprio": "LimitRTPRIO", "memlock": "LimitMEMLOCK", "nice": "LimitNICE"}
SCHEDULING = (
    "Nice",
    "CPUSchedulingPolicy",
    "CPUSchedulingPriority",
    "LimitRTPRIO",
    "LimitMEMLOCK",
    "LimitNICE",
    "IOSchedulingClass",
)
CONTROL = re.compile(r"ros2_control_node|controller_manager|ros2_control")


@rule(
    "warning",
    fix="unsafe",
    symptoms=["Could not enable FIFO RT scheduling policy", "Operation not permitted"],
)
def rt_limits_only_in_pam(robot: Robot) -> Iterator[Finding]:
    interested = {str(unit.get("User")) for unit in robot.units.ros if _schedules(unit) or _controls(robot, unit)}
    for unit in robot.units.ros:
        if not unit.complete or unit.get("PAMName") or robot.units.supervision(unit).in_container:
            continue
        missing = {}
        for item, grant in granted_limits(unit, robot):
            if not unit.get(SETTING[item]) and not _given_otherwise(unit, item):
                missing.setdefault(item, []).append(grant)
        if not missing:
            continue
        only_nice = set(missing) == {"nice"}
        control = _controls(robot, unit)
        severity = "error" if control else "warning"
        if str(unit.get("User")) in interested and not control and not _schedules(unit):
            severity = "info"
        if only_nice:
            severity = "info" if unit.get("Nice") else severity
        keys = [f"{SETTING[item]}={_value(item, grants[-1].value)}" for item, grants in missing.items()]
        yield finding(
            unit.get("User") or unit.where,
            f"limits.d grants {', '.join(missing)} only to logins: {unit.name} runs without it",
            advice=f"set {' and '.join(keys)} in the unit",
            related=[note(grant.line, "PAM reads this at login") for grants in missing.values() for grant in grants],
            fix=fix("set the limit in the unit", unit.new_line("Service", "\n".join(keys)), safe=False)
            if unit.editable
            else None,
            severity=severity,
        )


def _schedules(unit: Unit) -> bool:
    """Whether the unit sets any priority."""
    return any(unit.get(key) for key in SCHEDULING)


def _controls(robot: Robot, unit: Unit) -> bool:
    return any(CONTROL.search(text) for process in robot.units.started(unit) for text in process.texts)


def _given_otherwise(unit: Unit, item: str) -> bool:
    capabilities = {str(word) for word in unit.words("AmbientCapabilities")}
    if item == "rtprio":
        return unit.get("CPUSchedulingPolicy") in ("fifo", "rr") or "CAP_SYS_NICE" in capabilities
    return "CAP_IPC_LOCK" in capabilities if item == "memlock" else "CAP_SYS_NICE" in capabilities


def _value(item, value):
    if item == "memlock":
        return "infinity" if value in ("unlimited", "-1", "infinity") else f"{value}K"
    return value
