"""After= a unit that nothing starts.

## What it finds
`After=` of a unit of the same tree that has no `[Install]` section, is wanted or required by nothing, and
is started by no timer, socket, path or device.

## Why it matters on a robot
`After=` orders two units if both start; it starts neither. The unit that is waited for never runs, and the
wait is over at once.

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

## References
- systemd.unit(5), "After="
"""

from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import fix
from bringup_lint.api import note
from bringup_lint.api import rule


@rule("info", fix="unsafe")
def after_without_requires(robot: Robot):
    units = robot.units
    for unit in units.judged:
        for line in unit.assignments("After"):
            for word in line.value.words() if not line.opaque else ():
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
                    f"Nothing starts {word}, so there is nothing to wait for",
                    advice=f"add Wants={word}, or give it an [Install] section",
                    related=[note(other.where, "it has no [Install] section and nothing wants it")],
                    fix=fix(f"add Wants={word}", (line.end, f"\nWants={word}"), safe=False),
                )
