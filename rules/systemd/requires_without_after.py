"""Requires= or BindsTo= without an order.

## What it finds
A unit that requires another one, or is bound to it, when neither is ordered before the other, explicitly or
by systemd. Exempt are mounts, swaps and slices, which systemd orders itself, the distribution's sockets, and
the targets of early boot.

## Why it matters on a robot
A requirement does not define an order. systemd starts both units at the same time, and the planner may start
before the driver. When the driver fails to start, the planner is already running, because only a unit that
waits is held back. `BindsTo=` without `After=` has the same gap.

## Bad
```ini
[Unit]
Requires=base-driver.service
```

## Good
```ini
[Unit]
Requires=base-driver.service
After=base-driver.service
```

## When to ignore it
When the two units may start in any order, and a failed start of the other one must not stop this one.
`Wants=` says that better.

## References
- systemd.unit(5), "Requires=", "BindsTo="
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import fix
from bringup_lint.api import rule
from bringup_lint.api import systemd

ORDERED = (".mount", ".automount", ".swap", ".slice", ".scope")
EARLY = ("sysinit.target", "basic.target", "network-online.target", "local-fs.target")


@rule("warning", fix="unsafe", silent="units without an order start at once")
def requires_without_after(robot: Robot) -> Iterator[Finding]:
    units = robot.units
    for unit in units.judged:
        if unit.type == "target" or unit.unsure_of("After", "Before"):
            continue
        for key in ("Requires", "BindsTo"):
            for line in unit.assignments(key):
                if line.opaque or not line.span.source.judged:
                    continue
                for word in line.value.words():
                    if (
                        "%" in word
                        or word.endswith(ORDERED)
                        or word in EARLY
                        or word == unit.name
                        or not systemd.is_unit_name(word)
                    ):
                        continue
                    other = units.find(word, unit)
                    if other is None and (word.endswith(".socket") or len(units.candidates(word, unit.manager)) > 1):
                        continue
                    if units.ordered(unit, word) or (other and (other.masked or other.unsure_of("After", "Before"))):
                        continue
                    yield finding(
                        word,
                        f"{key}={word} does not define an order: both start at the same time, and if "
                        f"{word} fails, {unit.name} is already running",
                        advice=f"add After={word}",
                        fix=fix(f"add After={word}", (line.end, f"\nAfter={word}")),
                    )
