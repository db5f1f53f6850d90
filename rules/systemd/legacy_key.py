"""An obsolete key or value that systemd will remove one day.

## What it finds
One of these in a unit:

- a key or value that systemd reads only for old unit files;
- a key that it accepts but ignores;
- one of the five start limit keys that [Service] still accepts although they belong in [Unit].

A name that still has its effect is info, and so is a line that systemd ignores and that nothing replaces.

## Why it matters on a robot
The unit works on the release for which it was written. After an upgrade of the robot's operating system, the
limit, the log destination or the dependency is gone, or its scale has changed.

## Bad
```ini
[Service]
ExecStart=/usr/bin/robot-drivers
StandardOutput=syslog
MemoryLimit=2G
```

## Good
```ini
[Service]
ExecStart=/usr/bin/robot-drivers
StandardOutput=journal
MemoryMax=2G
```

## When to ignore it
When the same file must work on a release so old that it knows only the old name.

## References
- systemd.directives(7), the NEWS file of systemd
- journal: "Unit uses MemoryLimit=; please use MemoryMax= instead"
- journal: "Standard output type syslog is obsolete"
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import fix
from bringup_lint.api import rule
from bringup_lint.api.systemd import Legacy
from bringup_lint.api.systemd import Line
from bringup_lint.api.systemd import delete_lines
from bringup_lint.api.systemd import directives
from bringup_lint.api.systemd import move_lines


@rule(
    "warning",
    fix="safe",
    symptoms=["is obsolete", "= is deprecated", "is deprecated, please use", "Support for option"],
)
def legacy_key(robot: Robot) -> Iterator[Finding]:
    table = directives.legacy()
    written = {_place(line, str(line.assignment.section), str(line.key)) for line in robot.units.lines}
    for line in robot.units.lines:
        section = str(line.assignment.section)
        old = table.get((section, str(line.key), ""))
        if old is not None:
            yield _key(line, old, safe=old.fix == "safe" and not _competes(line, old, written))
            continue
        old = table.get((section, str(line.key), str(line.value)))
        if old is not None:
            change = fix(f"write {old.replacement}", (line.value, old.replacement), safe=old.fix == "safe")
            message = f"{line.key}={line.value} is obsolete: {old.note}"
            yield finding(line.value, message, advice=f"write {old.replacement}", fix=change)


def _place(line: Line, section: str, key: str) -> tuple[str, str, str]:
    """Unit, section and key; a drop-in counts to the unit that its folder names."""
    folder, _, name = line.file.source.name.rpartition("/")
    unit = folder.rpartition("/")[2].removesuffix(".d") if name.endswith(".conf") else name
    return unit, section, key


def _competes(line: Line, old: Legacy, written: set[tuple[str, str, str]]) -> bool:
    """Whether the unit has the new name too, so that another line may win; an alias keeps its place."""
    home = old.effect.partition(":")[2]
    if not home and not old.note.startswith("control group"):
        return False
    return _place(line, home or str(line.assignment.section), old.replacement) in written


def _key(line: Line, old: Legacy, *, safe: bool) -> Finding:
    key = line.key
    if old.effect == "ignored":
        advice = f"remove the line: {old.replacement}= replaces it" if old.replacement else "remove the line"
        removal = fix("remove the line", delete_lines(line.assignment), safe=safe)
        message, severity = f"{key}= was removed: systemd ignores the line", None if old.replacement else "info"
        return finding(key, message, advice=advice, fix=removal, severity=severity)
    if old.effect.startswith("moved:"):
        home = old.effect.partition(":")[2]
        text = f"{old.replacement}={line.value}"
        changes = move_lines(line.file, line.assignment, home, text)
        message = f"{key}= in [{line.assignment.section}] is obsolete: it belongs in [{home}]"
        name = f"as {old.replacement}=" if old.replacement != key else ""
        advice = f"move it to [{home}] {name}".strip()
        change = fix(advice, *changes, safe=safe)
        return finding(key, f"{message}, and still has its effect", advice=advice, fix=change, severity="info")
    if old.replacement:
        change = fix(f"rename to {old.replacement}", (key, old.replacement), safe=safe)
        message = f"{key}= is obsolete ({old.note}), and still has its effect"
        return finding(key, message, advice=f"use {old.replacement}=", fix=change, severity="info")
    return finding(key, f"{key}= is obsolete", advice=old.note, severity="info")
