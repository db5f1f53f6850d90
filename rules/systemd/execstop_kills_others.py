"""The stop of one unit ends processes of others.

## What it finds
`pkill` or `killall` in ExecStop= or ExecStopPost= with a name that fits the processes of another unit of the same
robot, or, in a template (`name@.service`), that of every other instance. Silent for a template of which the tree
enables one instance only.

## Why it matters on a robot
`pkill` looks at all processes of the machine. To stop or restart one camera, clock or driver ends all of them, and the
others count as stopped by a signal, which Restart=on-failure takes for a clean end.

## Bad
```ini
# camera@.service
ExecStart=/usr/bin/camera --device %I
ExecStop=/usr/bin/pkill -f camera
```

## Good
```ini
# camera@.service
ExecStart=/usr/bin/camera --device %I
```

## When to ignore it
When the units never run at the same time.

## References
- systemd.kill(5): systemd signals the processes of the unit by itself
- pgrep(1)
"""

import re
from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Located
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import note
from bringup_lint.api import regex
from bringup_lint.api import rule
from bringup_lint.api.shell import Command
from bringup_lint.api.systemd import Process
from bringup_lint.api.systemd import Unit
from bringup_lint.api.systemd import named_instances

PLAIN = regex(r"[\w./@ -]{3,}")
VALUED = ("-u", "-U", "-g", "-G", "-P", "-s", "-t", "-F")
ROLE = regex(r"(?:[^/\n]{1,200}/){0,20}roles/[^/\n]{1,200}/", hints="roles/")
SEVERAL = regex(r"\bitem\b|[$*]")
"""A name that stands for one after the other."""
STOPPING = ("ExecStop", "ExecStopPost")


@rule("warning", symptoms=["Main process exited, code=killed, status=15/TERM"])
def execstop_kills_others(robot: Robot) -> Iterator[Finding]:
    for unit in robot.units.running("kill"):
        for process in robot.units.processes(unit):
            if process.key not in STOPPING:
                continue
            for step in process.steps:
                pattern = _pattern(step.command)
                hit = _hit(robot, unit, pattern, "-f" in step.command.words) if pattern is not None else None
                if pattern is not None and hit is not None:
                    name, places = hit
                    yield finding(
                        pattern,
                        f"To stop {unit.name} also ends {name}: every process called '{pattern}' gets the signal",
                        advice="delete the line: systemd signals the processes of the unit",
                        related=[note(place, "this process fits too") for place in places],
                    )


def _pattern(command: Command) -> Located | None:
    """What pkill or killall looks for; None with a user, a parent or the like, which narrow it down."""
    words = command.words
    if command.name not in ("pkill", "killall") or any(word in VALUED for word in words):
        return None
    names = [word for word in words[1:] if not word.startswith("-")]
    return names[0] if len(names) == 1 and PLAIN.fullmatch(names[0]) else None


def _hit(robot: Robot, unit: Unit, pattern: Located, whole: bool) -> tuple[str, list[Located]] | None:
    """Whose processes the pattern fits besides those of the unit itself."""
    own = robot.units.started(unit)
    fits = unit.is_template and "%" not in pattern and any(_fits(each, pattern, whole) for each in own)
    if fits and not _has_one_instance(robot, unit):
        return "the other instances", [each.program for each in own[:1]]
    for other in robot.units.services:
        if other is unit or unit.fragment is None or other.fragment is None:
            continue
        if not robot.same_robot(unit.fragment.source, other.fragment.source):
            continue
        for process in robot.units.started(other):
            if _fits(process, pattern, whole) and not robot.units.conflict(unit, other):
                return other.name, [process.program]
    return None


def _has_one_instance(robot: Robot, unit: Unit) -> bool:
    """Whether the scripts and plays of the tree, or those of the role that a template is in, name one instance only."""
    role = ROLE.match(unit.where.source.name)
    named = named_instances(robot.files).get(unit.stem, ())
    names = {each.name for each in named if role is None or each.source.name.startswith(role[0])}
    return len(names) == 1 and not any(map(SEVERAL.search, names))


def _fits(process: Process, pattern: str, whole: bool) -> bool:
    text = str(process.line) if whole else process.name
    return re.search(rf"(?<![\w-]){re.escape(pattern)}", text) is not None
