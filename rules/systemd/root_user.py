"""The robot's software runs as root.

## What it finds
A service of the system manager that runs as root (`User=` is not set or is root, and there is no
`DynamicUser=`), or a command with the prefix `+`, that starts one of these:

- ROS;
- in a long-running service: an interpreter with a script of the robot;
- in a long-running service: a program in somebody's home folder;
- in a long-running service: a plain network relay such as socat.

Commands that change the user themselves, and containers, are exempt.

## Why it matters on a robot
Every node, every message parser and every script may then write firmware, change the network and read keys:
one bug in a driver compromises the whole robot. The robot's user cannot change files that root wrote (logs,
maps, caches). The shared memory of Fast DDS that root creates is closed to nodes of other users: topics are
listed, but data never arrives. A program below `/home` is worse: the owner of that home decides what root
runs.

## Bad
```ini
[Service]
ExecStart=/bin/bash -c 'source /opt/ros/jazzy/setup.bash && exec ros2 launch rover_bringup rover.launch.py'
```

## Good
```ini
[Service]
User=rover
SupplementaryGroups=dialout video
ExecStart=/bin/bash -c 'source /opt/ros/jazzy/setup.bash && exec ros2 launch rover_bringup rover.launch.py'
```

## When to ignore it
When the program needs full root and does little else, for example a flashing or provisioning tool. For a
driver, grant groups and capabilities instead.

## References
- systemd.exec(5), "User="
- <https://github.com/eProsima/Fast-DDS/issues/5258>
"""

import re
from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Fix
from bringup_lint.api import Located
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import fix
from bringup_lint.api import note
from bringup_lint.api import rule
from bringup_lint.api.systemd import Process
from bringup_lint.api.systemd import Unit
from bringup_lint.api.systemd import Units

ROOT = (None, "root", "0")
HOME = re.compile(r"/home/([^/]+)/")
INTERPRETER = re.compile(r"(?:python[0-9.]*|node|nodejs|ruby|perl|bash|sh|dash)$")
RELAYS = frozenset({"socat", "nc", "ncat", "netcat", "websockify", "ttyd", "gunicorn", "uvicorn", "mjpg_streamer"})
CONTAINERS = frozenset(
    {"docker", "docker-compose", "podman", "podman-compose", "nerdctl", "systemd-nspawn", "machinectl", "lxc"}
)
DROPPERS = frozenset({"setpriv", "runuser", "su", "sudo", "gosu", "su-exec", "chpst", "s6-setuidgid"})


@rule(
    "warning",
    fix="unsafe",
    tags=["CWE-250"],
    symptoms=["$HOME is not set", "Failed to get logging directory"],
)
def root_user(robot: Robot) -> Iterator[Finding]:
    units = robot.units
    for unit in units.services:
        if unit.manager == "user" or unit.unsure_of("User", "DynamicUser", section="Service"):
            continue
        user = unit.get("User")
        is_root = user in ROOT and not is_on(unit.get("DynamicUser"))
        for process in units.started(unit):
            if not (is_root or "+" in process.prefixes) or changes_user(process):
                continue
            what, where, confidence = runs(robot, unit, process)
            if not what:
                continue
            if not is_root:
                message = f"'+' runs {what} as root, whatever User={user} says"
                yield finding(
                    process.program,
                    message,
                    advice="remove the '+'",
                    related=[note(user, "has no effect here")],
                )
            else:
                yield finding(
                    user or unit.where,
                    f"{unit.name} runs {what} as root" + ("" if user else ": it has no User="),
                    advice="add a User= of its own, and SupplementaryGroups= for the devices that it opens",
                    related=[note(where, "the unit starts it here")],
                    fix=_fix(units, unit, user),
                    confidence=confidence,
                )
            break


def is_on(value: Located | None) -> bool:
    return value is not None and value.lower() in ("yes", "true", "on", "1", "y", "t")


def changes_user(process: Process) -> bool:
    names = {word.rpartition("/")[2] for step in process.steps for word in step.command.words[:1]}
    names |= {
        word.rpartition("/")[2]
        for step in process.steps
        for word in step.command.words[1:2]
        if step.command.name == "exec"
    }
    return bool(names & (DROPPERS | CONTAINERS))


def runs(robot: Robot, unit: Unit, process: Process) -> tuple[str, Located, str] | tuple[None, None, None]:
    """What it runs that needs no root, where, and how sure that is."""
    if process.mentions_ros:
        where = process.ros[0][1].where if process.ros else process.program
        return "ROS", where, "high"
    if unit in robot.units.presumed_ros and process.lost_script:
        return (
            f"{process.lost_script} (probably ROS: it is not in this tree)",
            process.lost_script,
            "medium",
        )
    if unit.get("Type") in ("oneshot", "forking"):
        return None, None, None
    paths = [word for word in process.argv[:2] if word.startswith("/")]
    for word in paths:
        if home := HOME.match(word):
            return f"{word}, which user {home[1]} can change,", word, "high"
    if (
        INTERPRETER.match(process.name)
        and len(paths) > 1
        and not paths[1].startswith(("/usr/lib/", "/usr/share/", "/usr/bin/", "/lib/"))
    ):
        return str(paths[1]), paths[1], "medium"
    if process.name in RELAYS:
        return f"{process.name}, which needs no root,", process.program, "medium"
    return None, None, None


def _fix(units: Units, unit: Unit, user: Located | None) -> Fix | None:
    others = {
        str(other.get("User")) for other in units.ros if other.get("User") not in ROOT and "%" not in other.get("User")
    }
    if len(others) != 1:
        return None
    (name,) = others
    return fix(
        f"run it as {name}, like the other ROS services",
        (user, name) if user else unit.new_line("Service", f"User={name}"),
        safe=False,
    )
