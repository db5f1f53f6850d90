"""An unknown % specifier: systemd ignores the line, or refuses the unit.

## What it finds
A % before a letter or digit that is not a specifier, as in date +%F. A % before a blank or at the end of a
word is literal, and %% is a literal %.

## Why it matters on a robot
In Exec lines, an unknown specifier prevents the whole unit from loading. In other settings, systemd ignores
the line or the word.

## Bad
```ini
[Service]
ExecStartPre=/bin/bash -c 'mkdir -p /var/log/robot/$(date +%F)'
ExecStart=/usr/bin/robot-drivers
```

## Good
```ini
[Service]
ExecStartPre=/bin/bash -c 'mkdir -p /var/log/robot/$(date +%%F)'
ExecStart=/usr/bin/robot-drivers
```

## When to ignore it
Only if the robot's systemd is newer than this tool and knows the specifier.

## References
- systemd.unit(5), "Specifiers"
- journal: "Failed to resolve unit specifiers in %F: Invalid slot"
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import fix
from bringup_lint.api import rule
from bringup_lint.api.systemd import Line


@rule(
    "error",
    fix="unsafe",
    symptoms=["Failed to resolve unit specifiers", "Failed to resolve specifiers", "Invalid slot"],
)
def unescaped_percent(robot: Robot) -> Iterator[Finding]:
    for line in robot.units.wrong_lines:
        bad = [problem for problem in line.problems if problem.code == "unknown-specifier"]
        if not bad:
            continue
        first = bad[0]
        edits = [(problem.where, f"%{problem.where}") for problem in bad]
        known = line.directive.type in ("units", "socket-units", "trigger-unit", "slice", "service-unit")
        what = "is not a specifier that a unit name may contain" if known else "is not a specifier"
        yield finding(
            first.where,
            f"{first.where} {what}: {line.consequence(first)}",
            advice=f"write %{first.where} for a literal %",
            fix=fix("double the %", *edits, safe=False) if _plain(line) else None,
        )


def _plain(line: Line) -> bool:
    """Whether every % of the value is in the file as systemd reads it."""
    return "%%" not in line.value
