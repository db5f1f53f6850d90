"""ReadWritePaths=/tmp has no use with PrivateTmp=yes.

## What it finds
/tmp or /var/tmp in ReadWritePaths= of a unit with PrivateTmp=yes, which gives the unit its own writable /tmp.

## Why it matters on a robot
Nothing breaks. But the line suggests that the service shares /tmp with others, which it does not.

## Bad
```ini
[Service]
ProtectSystem=strict
PrivateTmp=yes
ReadWritePaths=/var/lib/rover /tmp
```

## Good
```ini
[Service]
ProtectSystem=strict
PrivateTmp=yes
ReadWritePaths=/var/lib/rover
```

## When to ignore it
When a drop-in on some robots sets PrivateTmp=no.

## References
- systemd.exec(5), PrivateTmp=
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Fix
from bringup_lint.api import Located
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import fix
from bringup_lint.api import note
from bringup_lint.api import rule
from bringup_lint.api.systemd import Assignment
from bringup_lint.api.systemd import paths


@rule("info", fix="safe", silent="the setting has no effect and is not reported")
def privatetmp_redundant(robot: Robot) -> Iterator[Finding]:
    for unit in robot.units.judged:
        private = unit.flag("PrivateTmp")
        if not private:
            continue
        lines = {word.span: line for line in unit.assignments("ReadWritePaths") for word in line.value.words()}
        for word, path, _ in paths(unit, "ReadWritePaths"):
            line = lines.get(word.span)
            if path in ("/tmp", "/var/tmp"):
                yield finding(
                    word,
                    f"PrivateTmp= gives {unit.name} its own writable {path}: the entry is redundant",
                    advice="remove the entry",
                    related=[note(private.where, "gives it its own /tmp")],
                    fix=_without(line, word) if unit.editable and line is not None else None,
                )


def _without(line: Assignment, word: Located) -> Fix:
    """The line without a word of it."""
    text = " ".join(other for other in line.value.words() if other.span != word.span)
    return fix("remove the entry", (line.value, text) if text else (line.span, "# ReadWritePaths= was redundant"))
