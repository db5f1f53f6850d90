"""Wants=network-online.target without waiting for it.

## What it finds
A unit with `Wants=`, `Requires=` or `BindsTo=` of `network-online.target` that is not ordered after it,
neither itself nor through a unit that it is ordered after.

## Why it matters on a robot
A requirement does not order anything: systemd starts the service and the wait for the network at the same
moment. The line looks like a cure for a start that comes too early, delays the boot, and cures nothing.

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

## References
- systemd.unit(5), "Wants=" and "After="
- systemd.special(7), "network-online.target"
"""

from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import fix
from bringup_lint.api import note
from bringup_lint.api import rule

ONLINE = "network-online.target"


@rule("warning", fix="safe", symptoms=["does not match an available interface", "Network is unreachable"])
def network_online_no_after(robot: Robot):
    units = robot.units
    for unit in units.judged:
        lines = [pair for key in ("Wants", "Requires", "BindsTo") for pair in unit.naming(key, ONLINE)]
        if not lines or unit.type in ("target", "timer") or unit.unsure_of("After") or unit.manager == "user":
            continue
        if units.waits_for(unit, ONLINE):
            continue
        line, word = lines[0]
        earlier = [other for _, other in unit.naming("After", "network.target")]
        edit = (earlier[0], ONLINE) if earlier else (line.end, f"\nAfter={ONLINE}")
        yield finding(
            word,
            f"{unit.name} pulls {ONLINE} in but does not wait for it: both start at the same time",
            advice=f"add After={ONLINE}",
            related=[note(other, "reached before any interface has an address") for other in earlier],
            fix=fix(f"order after {ONLINE}", edit),
        )
