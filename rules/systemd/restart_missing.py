"""Nothing restarts the ROS service when it exits.

## What it finds
A service of ROS, one that only connects to a board, a clock or another computer (MicroXRCEAgent, ptp4l), or one with
Type=simple and WantedBy= whose program the tree does not hold or that never ends, without Restart= that should keep
running: it is not Type=oneshot or Type=forking, no timer or path unit starts it, it is not there to set something up by
its name, and it runs more than a command-line tool such as ros2 topic. It is an info in three cases:

- Restart=no is set explicitly, which is a decision;
- scripts or plays install the service and nothing enables it, or a play disables it (`enabled: false`): somebody starts
  it, and is there;
- the start script of the service is not in the tree.

Any service with Restart=no and RestartSec= in one file, without RestartForceExitStatus=, is a warning: one of the two
lines is not what was meant.

## Why it matters on a robot
The first segmentation fault or the first unplugged cable stops the robot's software until somebody logs in.
On a robot in the field, that is the end of the mission.

## Bad
```ini
[Service]
ExecStart=/bin/bash -c 'source /opt/ros/jazzy/setup.bash && exec ros2 launch rover base.launch.py'
```

## Good
```ini
[Unit]
StartLimitIntervalSec=60
StartLimitBurst=5

[Service]
ExecStart=/bin/bash -c 'source /opt/ros/jazzy/setup.bash && exec ros2 launch rover base.launch.py'
Restart=always
RestartSec=2
```

## When to ignore it
When an operator must decide whether the robot may move again after a crash, or when another supervisor
restarts the processes.

## References
- systemd.service(5), Restart=: the default is no
"""

import re
from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Fix
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import fix
from bringup_lint.api import note
from bringup_lint.api import regex
from bringup_lint.api import rule
from bringup_lint.api.systemd import Process
from bringup_lint.api.systemd import Unit
from bringup_lint.api.systemd import Units
from bringup_lint.api.systemd import kept_off
from bringup_lint.api.systemd import never_enabled_units
from bringup_lint.api.systemd import only_connects

TOOLS = "cli"
INSTALLING = ("shell-script", "ansible", "cloud-init")
OF_LAUNCH = " (ros2 launch often exits with status 0)"
SETS_UP = regex(
    r"set-?up|init|conf|once|boot|load|prepar|fix|updat|install|reset|clean|bind|mount|sync|generat|creat|enabl|check"
    r"|start-?up|provision|resize|expand|migrat|restore|permission|governor|-up$",
    re.I,
)
"""Parts of the names of units that do something once."""


@rule("warning", fix="unsafe", silent="systemd reports the end of the service, as for every service, and does nothing")
def restart_missing(robot: Robot) -> Iterator[Finding]:
    units = robot.units
    ros = [*units.ros, *units.ros1, *units.presumed_ros]
    agents = [unit for unit in units.services if unit not in ros and only_connects(unit, units)]
    known = {unit.name for unit in (*ros, *agents)}
    daemons = [unit for unit in units.services if unit.name not in known and _is_daemon(robot, unit)]
    yield from (_waiting_in_vain(unit) for unit in units.services if _waits(units, unit))
    by_hand: list[Unit] | None = None
    for unit in (*ros, *agents, *daemons):
        if _waits(units, unit):
            continue
        policy = units.restart(unit)
        if policy.restart != "no" or not unit.complete or unit.name in units.triggered:
            continue
        if policy.restart_at is None and unit.get("Restart"):
            continue
        if unit.get("Type") in ("oneshot", "forking") or not _stays(units, unit):
            continue
        if by_hand is None:
            by_hand = list(_started_by_hand(robot)) if robot.of_kind(*INSTALLING) else []
        chosen, sure = policy.restart_at is not None, unit not in units.presumed_ros and unit not in daemons
        yield finding(
            policy.restart_at or unit.where,
            f"When the process of {unit.name} exits, nothing restarts it",
            advice=f"set Restart=always{OF_LAUNCH if units.launches(unit) else ''} and a start limit",
            related=[note(process.line, "this process") for process in units.started(unit)[:1]],
            fix=_restart(unit) if unit.editable and not chosen else None,
            severity="info"
            if chosen or unit in by_hand or (unit in units.presumed_ros and not _is_daemon(robot, unit))
            else "warning",
            confidence="high" if sure else "medium",
        )


def _started_by_hand(robot: Robot) -> Iterator[Unit]:
    off = kept_off(robot.files)
    yield from never_enabled_units(robot.files, robot.units)
    yield from (unit for unit in robot.units.services if unit.stem in off)


def _waits(units: Units, unit: Unit) -> bool:
    """Whether a unit says how long to wait before a restart, and that there is none."""
    waits, policy = unit.get("RestartSec"), units.restart(unit)
    if waits is None or policy.restart_at is None or policy.restart != "no" or unit.get("Type") == "oneshot":
        return False
    if unit.has("RestartForceExitStatus"):
        return False
    source = policy.restart_at.span.source
    return waits.span.source is source and source.text.count("Restart=") == 1 and unit.name not in units.triggered


def _waiting_in_vain(unit: Unit) -> Finding:
    restart, waits = unit.get("Restart"), unit.get("RestartSec")
    assert restart is not None
    assert waits is not None
    return finding(
        restart,
        f"Restart={restart} lets {unit.name} stay down when its process ends: RestartSec={waits} has no effect",
        advice="set Restart=always, or remove RestartSec=",
        related=[note(waits, "the time before a restart")],
    )


def _is_daemon(robot: Robot, unit: Unit) -> bool:
    """Whether a service says itself that its process is there to stay, and nothing tells otherwise."""
    if unit.get("Type") != "simple" or not unit.has("WantedBy", "Install") or SETS_UP.search(unit.name):
        return False
    if unit.flag("RemainAfterExit") or unit.has("SuccessAction") or unit.has("ConditionFirstBoot", "Unit"):
        return False
    return all(
        robot.units.never_ends(process) is not None or not _is_held(robot, process)
        for process in robot.units.started(unit)
    )


def _is_held(robot: Robot, process: Process) -> bool:
    """Whether the tree holds a program of the command line, or the line is a script of its own."""
    if "-c" in process.argv:
        return True
    programs = [process.program, *(word for word in process.argv[1:] if word.endswith((".sh", ".py")))]
    return any(word.startswith("/") and robot.find(word, word.span.source) for word in programs)


def _stays(units: Units, unit: Unit) -> bool:
    """Whether it starts more than tools such as ros2 topic, which exit by themselves."""
    kinds = {found.kind for process in units.started(unit) for _, found in process.ros}
    return kinds != {TOOLS}


def _restart(unit: Unit) -> Fix:
    edits = [unit.new_line("Service", "Restart=always\nRestartSec=2")]
    if not (unit.has("StartLimitBurst", "Unit") or unit.has("StartLimitIntervalSec", "Unit")):
        edits.insert(0, unit.new_line("Unit", "StartLimitIntervalSec=60\nStartLimitBurst=5"))
    return fix("restart it, at most 5 times a minute", *edits, safe=False)
