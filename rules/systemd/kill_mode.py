"""KillMode= lets nodes survive the stop.

## What it finds
KillMode=process or KillMode=none on a service that starts ROS 2, and on one whose script of the tree leaves programs in
the background without a trap that ends them. One-shot services and containers are exempt. That a restart starts them
twice is not said where the script first ends those of an earlier start by their name, which they outlive until then.

## Why it matters on a robot
systemd stops at most the main process. After a crash of ros2 launch, or when the main process is a shell, the
nodes keep driving the robot, and the restart starts them a second time.

## Bad
```ini
[Service]
ExecStart=/bin/bash -c 'source /opt/ros/jazzy/setup.bash && exec ros2 launch rover base.launch.py'
KillMode=process
```

## Good
```ini
[Service]
ExecStart=/bin/bash -c 'source /opt/ros/jazzy/setup.bash && exec ros2 launch rover base.launch.py'
KillSignal=SIGINT
KillMode=mixed
```

## When to ignore it
When processes must outlive the service on purpose, such as a tmux session or a daemon that the service only
starts.

## References
- systemd.kill(5), KillMode=: process is not recommended, none is deprecated
"""

import re
from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import Source
from bringup_lint.api import finding
from bringup_lint.api import fix
from bringup_lint.api import note
from bringup_lint.api import regex
from bringup_lint.api import rule
from bringup_lint.api.shell import SHORT
from bringup_lint.api.shell import Command
from bringup_lint.api.shell import ends_after
from bringup_lint.api.systemd import Unit

TRAP = regex(
    r"\btrap\b[^\n]{0,200}\b(?:kill|pkill|killall|EXIT|(?:SIG)?(?:TERM|INT|HUP))\b"
    r"|^[ \t]*(?:tmux|screen|setsid|nohup)[ \t]|\bdisown\b",
    re.M,
)
"""The script ends them itself, or means them to outlive it."""
ENDS = regex(r"\b(?:pkill|killall)\b([^\n;&|]{0,200})", hints="pkill killall")
NAME = regex(r"[\w.+-]+")
OF_SHORT_SCRIPT = (
    "end the script with wait, so that it runs for as long as what it starts, and set KillMode=mixed: without wait, "
    "systemd would end it together with the script"
)


@rule(
    "warning",
    fix="unsafe",
    symptoms=["left-over process", "remains running after unit stopped", "Unit configured to use KillMode=none"],
)
def kill_mode(robot: Robot) -> Iterator[Finding]:
    ros = set(map(id, robot.units.ros))
    for unit in robot.units.services:
        if not unit.has("KillMode"):
            continue
        service = robot.units.supervision(unit)
        mode = service.kill_mode
        if mode.value not in ("process", "none") or unit.get("Type") == "oneshot" or service.in_container:
            continue
        is_ros = id(unit) in ros
        left = None if is_ros else next(_left(robot, unit), None)
        if not is_ros and left is None:
            continue
        stops = (
            f"systemd stops only the main process of {unit.name}"
            if mode.value == "process"
            else f"systemd stops no process of {unit.name}"
        )
        what, them = ("nodes that survive keep", "them")
        if left is not None:
            what, them = ("what its script leaves in the background keeps", "it")
        is_doubled = robot.units.restart(unit).restart != "no" and not (left and _ends_earlier(left))
        again = f", and a restart starts {them} twice" if is_doubled else ""
        waits = not _ends_at_once(robot, unit)
        yield finding(
            mode.where,
            f"KillMode={mode.value}: {stops}; {what} running{again}",
            advice="set KillMode=mixed" if waits else OF_SHORT_SCRIPT,
            related=[note(left.words[0], "this survives the stop")] if left is not None else [],
            fix=fix("set KillMode=mixed", (mode.where, "mixed"), safe=False) if unit.editable and waits else None,
        )


def _ends_at_once(robot: Robot, unit: Unit) -> bool:
    """Whether a script of a service starts something in the background and ends: it does not run on until the stop, at
    which another mode would end what it left."""
    if unit.get("Type") == "forking" or unit.flag("RemainAfterExit"):
        return False
    return any(
        _is_left(step.command) and ends_after(process, step)
        for process in robot.units.started(unit)
        for step in process.steps
    )


def _left(robot: Robot, unit: Unit) -> Iterator[Command]:
    """What the scripts of a unit leave in the background, where no other command of the unit may end it; first what
    they do not end before they start it."""
    if unit.get("Type") == "forking" or unit.get("ExecStop") or unit.get("ExecStopPost"):
        return
    left = [step.command for process in robot.units.processes(unit) for step in process.steps if _stays(step.command)]
    yield from sorted(left, key=_ends_earlier)


def _stays(command: Command) -> bool:
    return _is_left(command) and not command.words[0].span.source.matches(TRAP)


def _is_left(command: Command) -> bool:
    return command.background and bool(command.words) and command.words[0] not in SHORT


def _ends_earlier(command: Command) -> bool:
    """Whether the script of a command first ends the program of an earlier start by its name."""
    place = command.words[0].span
    ended = place.source.once(_ended, lambda: _ended(place.source))
    return any(ended.get(word.rpartition("/")[2], place.start) < place.start for word in command.words[:2])


def _ended(source: Source) -> dict[str, int]:
    """The words behind the commands of a script that end processes by their names, each with its first offset."""
    found: dict[str, int] = {}
    for match in ENDS.finditer(source.said):
        for name in NAME.findall(match[1]):
            found.setdefault(name, match.start())
    return found
