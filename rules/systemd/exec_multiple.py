"""More than one ExecStart= in a service that is not oneshot: systemd refuses the unit.

## What it finds
Two or more commands in ExecStart=, after all drop-ins, in a service that is not Type=oneshot: several lines,
a line in a drop-in without an empty ExecStart= before it, or commands separated by a semicolon. The drop-in may be
for a service of Ubuntu or Debian; of one that is oneshot, the command that it was to replace runs first.

## Why it matters on a robot
systemd refuses the whole unit. With such a drop-in, a packaged service that worked before no longer loads.

## Bad
```ini
# robot-drivers.service.d/arguments.conf
[Service]
ExecStart=/usr/bin/robot-drivers --simulate
```

## Good
```ini
# robot-drivers.service.d/arguments.conf
[Service]
ExecStart=
ExecStart=/usr/bin/robot-drivers --simulate
```

## When to ignore it
Never: systemd does not load the unit.

## References
- systemd.service(5), "ExecStart="
- journal: "Service has more than one ExecStart= setting, which is only allowed for Type=oneshot services. Refusing."
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import fix
from bringup_lint.api import note
from bringup_lint.api import rule
from bringup_lint.api.systemd import Command
from bringup_lint.api.systemd import Line
from bringup_lint.api.systemd import Unit


@rule("error", fix="unsafe", symptoms=["Service has more than one ExecStart= setting"])
def exec_multiple(robot: Robot) -> Iterator[Finding]:
    lines = {line.value.span: line for line in robot.units.lines if line.key == "ExecStart"}
    for unit in robot.units.services:
        added = _added(robot, unit) if unit.fragment is None else None
        if added is not None:
            yield added
            continue
        if unit.uncertain or unit.get("Type") == "oneshot":
            continue
        found = [lines[value.span] for value in unit.values("ExecStart") if value.span in lines]
        commands = [(line, command) for line in found for command in line.commands]
        if len(commands) > 1:
            yield _finding(unit, *commands[0], *commands[1])


def _added(robot: Robot, unit: Unit) -> Finding | None:
    """What drop-ins add to the command of a service that the distribution ships."""
    given = unit.assignments("ExecStart")
    kind = robot.units.shipped_type(unit.name) if unit.manager == "system" else ""
    if not kind or not given or unit.uncertain or unit.masked or not all(each.value for each in given):
        return None
    first = given[0]
    is_oneshot = str(unit.get("Type") or kind) == "oneshot"
    happens = "runs both, its own first" if is_oneshot else "refuses the unit"
    start = first.span.start
    return finding(
        first.value,
        f"This is added to the ExecStart= that {unit.name} has from the distribution: systemd {happens}",
        advice="add an empty ExecStart= above: it resets the command of the unit file",
        fix=fix("reset ExecStart= first", (first.span.source.span(start, start), "ExecStart=\n")),
        severity="warning" if is_oneshot else None,
    )


def _finding(unit: Unit, first_line: Line, first: Command, line: Line, second: Command) -> Finding:
    message = f"More than one ExecStart= command in {unit.name}: systemd refuses the unit"
    change = None
    advice = "use Type=oneshot for a sequence, ExecStartPre= for preparation, or a unit for each process"
    if line.file.dropin and not first_line.file.dropin:
        start = line.assignment.span.start
        advice = "add an empty ExecStart= above: it resets the command of the unit file"
        change = fix("reset ExecStart= first", (line.assignment.span.source.span(start, start), "ExecStart=\n"))
    return finding(second.where, message, advice=advice, related=[note(first.where, "the first command")], fix=change)
