"""An unknown % specifier: systemd does not take the line, or the unit does not load.

## What it finds
A % with a letter or digit behind it that is no specifier, as in date +%F. A % before a blank or at the end
of a word stands for itself, and %% is a literal %.

## Why it matters on a robot
In Exec lines an unknown specifier stops the whole unit from loading; in other settings the line or the word
is dropped.

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


@rule(
    "error",
    fix="unsafe",
    symptoms=["Failed to resolve unit specifiers", "Failed to resolve specifiers", "Invalid slot"],
)
def unescaped_percent(robot: Robot) -> Iterator[Finding]:
    for line in robot.units.lines:
        bad = [problem for problem in line.problems if problem.code == "unknown-specifier"]
        if not bad:
            continue
        first = bad[0]
        edits = [(problem.where, f"%{problem.where}") for problem in bad]
        known = line.directive.type in ("units", "socket-units", "trigger-unit", "slice", "service-unit")
        what = "is no specifier that a unit name may hold" if known else "is not a specifier"
        yield finding(
            first.where,
            f"{first.where} {what}: {line.consequence(first)}",
            advice=f"write %{first.where} for a literal %",
            fix=fix("double the %", *edits, safe=False) if _plain(line) else None,
        )


def _plain(line):
    """Whether every % of the value stands in the file as systemd reads it."""
    return "%%" not in line.value
