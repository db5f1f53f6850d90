"""After= names a unit that nothing starts.

## What it finds
`After=` of a service in the same tree that nothing starts: it has no `[Install]` section, no unit wants or
requires it, and no timer, socket, path or device activates it.

## Why it matters on a robot
`After=` orders two units if both start, but it starts neither. The unit that should come first never runs,
and this one starts at once.

## Bad
```ini
[Unit]
After=calibration.service
```

## Good
```ini
[Unit]
Wants=calibration.service
After=calibration.service
```

## When to ignore it
When something outside of this tree starts the other unit: a script with `systemctl start`, a fleet agent, or
another package.

## References
- systemd.unit(5), "After="
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import fix
from bringup_lint.api import note
from bringup_lint.api import rule


@rule("info", fix="unsafe", silent="an order between units that do not both start has no effect and is not reported")
def after_without_requires(robot: Robot) -> Iterator[Finding]:
    units = robot.units
    for unit in units.judged:
        for line in unit.assignments("After"):
            if line.opaque:
                continue
            for word in line.value.words():
                other = units.find(word, unit)
                if (
                    other is None
                    or other is unit
                    or other.type != "service"
                    or other.unsure_of()
                    or units.is_started(other)
                ):
                    continue
                yield finding(
                    word,
                    f"Nothing starts {word}, so After= has no effect",
                    advice=f"add Wants={word}, or give {word} an [Install] section",
                    related=[note(other.where, "it has no [Install] section and nothing wants it")],
                    fix=fix(f"add Wants={word}", (line.end, f"\nWants={word}"), safe=False),
                )
