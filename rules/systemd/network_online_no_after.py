"""Wants=network-online.target without waiting for it.

## What it finds
A unit with `Wants=`, `Requires=` or `BindsTo=` of `network-online.target` that is not ordered after it,
either directly or through another unit.
Exempt are units with a command that waits for the network itself.

## Why it matters on a robot
A requirement does not define an order: systemd starts the service and the wait for the network at the same
time. The line delays the boot, but the service still starts too early.

## Bad
```ini
[Unit]
Wants=network-online.target
After=network.target
```

## Good
```ini
[Unit]
Wants=network-online.target
After=network-online.target
```

## When to ignore it
When the unit only needs the network to come up at some time, and does not wait for it itself.

## References
- systemd.unit(5), "Wants=" and "After="
- systemd.special(7), "network-online.target"
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import fix
from bringup_lint.api import note
from bringup_lint.api import rule
from bringup_lint.api.systemd import waits_itself

ONLINE = "network-online.target"


@rule("warning", fix="unsafe", symptoms=["does not match an available interface", "Network is unreachable"])
def network_online_no_after(robot: Robot) -> Iterator[Finding]:
    units = robot.units
    for unit in units.judged:
        lines = [pair for key in ("Wants", "Requires", "BindsTo") for pair in unit.naming(key, ONLINE)]
        if not lines or unit.type in ("target", "timer") or unit.unsure_of("After") or unit.manager == "user":
            continue
        if units.waits_for(unit, ONLINE) or waits_itself(unit, units):
            continue
        line, word = lines[0]
        earlier = [other for _, other in unit.naming("After", "network.target")]
        edit = (earlier[0], ONLINE) if earlier else (line.end, f"\nAfter={ONLINE}")
        yield finding(
            word,
            f"{unit.name} pulls in {ONLINE} but does not wait for it: both start at the same time",
            advice=f"add After={ONLINE}",
            related=[note(other, "reached before any interface has an address") for other in earlier],
            fix=fix(f"order after {ONLINE}", edit),
        )
