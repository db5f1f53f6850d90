"""PIDFile= of a service that does not fork.

## What it finds
`PIDFile=` in a service with another type than `forking`. One finding names the lines of one unit.

## Why it matters on a robot
At the start, systemd reads the file with Type=forking only. The unit looks as if a program were watched by its PID,
which some service scripts write with care, and in truth systemd watches the process that it started itself. It only
removes the file after the stop. Two units
with one PIDFile= remove each other's file when they stop.

## Bad
```ini
[Service]
Type=simple
PIDFile=/run/helm.pid
ExecStart=/opt/boat/helm
```

## Good
```ini
[Service]
Type=exec
ExecStart=/opt/boat/helm
```

## When to ignore it
When another program reads the file, and systemd is only to remove it after the stop.

## References
- systemd.service(5), "PIDFile="
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import note
from bringup_lint.api import rule
from bringup_lint.api.systemd import Unit


@rule("info", silent="systemd reads the file of a forking service only, and says nothing of any other")
def pidfile_unused(robot: Robot) -> Iterator[Finding]:
    for unit in robot.units.services:
        kind, path = unit.get("Type"), unit.get("PIDFile")
        if not path or ".." in path or kind in ("forking", "dbus"):
            continue
        if unit.uncertain or unit.fragment is None or "$" in (kind or "") or _is_used(robot, unit, path):
            continue
        yield finding(
            path,
            f"systemd reads no PID file with Type={kind or 'simple'}: "
            + ("the line has no effect" if kind == "oneshot" else f"{unit.name} is not watched by it"),
            advice="remove the line, or use Type=forking where the program forks and writes the file",
            related=[note(kind, "the type")] if kind else (),
        )


def _is_used(robot: Robot, unit: Unit, path: str) -> bool:
    """Whether systemd or a program uses the file: systemd reads it after ExecStartPost= and ExecReload= of every type,
    a program that notifies systemd says its main process by itself, and one that stays writes the file that it is
    given."""
    if unit.has("ExecStartPost") or unit.has("ExecReload") or (unit.get("Type") or "").startswith("notify"):
        return True
    if unit.get("Type") == "oneshot":
        return False
    return any(path in str(word) for process in robot.units.started(unit) for word in process.argv)
