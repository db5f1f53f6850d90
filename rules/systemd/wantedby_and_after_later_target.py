"""A unit that one target wants, and that waits for a later target.

## What it finds
A unit that one target wants (`WantedBy=`, a `.wants` link) and that is ordered after another target which
itself waits for the first one: `WantedBy=multi-user.target` with `After=graphical.target`. A target waits for
all units that it wants, so that the unit waits for itself.

`After=` and `WantedBy=` of the same target are exempt: the explicit order suppresses the implicit one. It is
an info when nothing starts the targets together.

## Why it matters on a robot
At boot, systemd deletes the start job of the unit to break the cycle. The robot boots without the unit, no
unit is marked as failed, and `systemctl start` by hand works.

## Bad
```ini
[Unit]
After=graphical.target

[Install]
WantedBy=multi-user.target
```

## Good
```ini
[Unit]
After=graphical.target

[Install]
WantedBy=graphical.target
```

## When to ignore it
The info, when the unit is never enabled in this combination.

## References
- systemd.target(5), "Default Dependencies"
- systemd.special(7)
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import note
from bringup_lint.api import rule


@rule("error", symptoms=["Found ordering cycle on", "deleted to break ordering cycle starting with"])
def wantedby_and_after_later_target(robot: Robot) -> Iterator[Finding]:
    for cycle in robot.units.cycles:
        lines = {edge: edge.where for edge in cycle.waits if edge.where and edge.where.source.judged}
        if not lines or not cycle.against_targets:
            continue
        name = next(unit for unit in cycle.units if not unit.endswith(".target"))
        later = next(edge for edge in cycle.edges if edge.target.name == name)
        sooner = next(edge for edge in cycle.edges if edge.source.name == name)
        steps = [
            note(edge.where, f"{edge.target.name} waits for {edge.source.name}") for edge in cycle.waits if edge.where
        ]
        effect = "cannot start" if cycle.fatal else "is dropped at boot" if cycle.root else "may be dropped"
        yield finding(
            lines.get(later) or next(iter(lines.values())),
            f"{name} waits for {later.source.name}, which waits for {sooner.target.name}, "
            f"which waits for {name}: the unit {effect}",
            advice=f"let {later.source.name} want the unit (WantedBy={later.source.name}), or remove the After=",
            related=[step for step in steps if step.span != later.where],
            chain=steps,
            severity=None if cycle.root else "info",
        )
