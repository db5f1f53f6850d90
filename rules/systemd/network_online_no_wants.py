"""After=network-online.target without anything that pulls the target in.

## What it finds
A unit ordered after `network-online.target` while neither the unit nor one that it depends on has `Wants=`
or `Requires=` of it, and no other unit of the tree brings it in at boot.

## Why it matters on a robot
`network-online.target` is not part of a normal boot: nothing starts it unless a unit asks for it. Ordering
after something that is not started is void, so the service starts at once, before the interfaces have
addresses. `systemd-analyze verify` says nothing.

## Bad
```ini
[Unit]
After=network-online.target
```

## Good
```ini
[Unit]
Wants=network-online.target
After=network-online.target
```

## References
- systemd.special(7), "network-online.target"
- <https://systemd.io/NETWORK_ONLINE/>
"""

from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import fix
from bringup_lint.api import rule

ONLINE = "network-online.target"


@rule("warning", fix="safe", symptoms=["does not match an available interface", "Network is unreachable"])
def network_online_no_wants(robot: Robot):
    units = robot.units
    for unit in units.judged:
        for line, word in unit.naming("After", ONLINE):
            if unit.manager == "user" or unit.unsure_of("Wants", "Requires"):
                continue
            if units.brings_in(unit, ONLINE) or units.brought_in(unit, ONLINE):
                continue
            yield finding(
                word,
                f"Nothing pulls {ONLINE} in, so this After= has no effect: {unit.name} starts without waiting for the "
                "network",
                advice=f"add Wants={ONLINE}",
                fix=fix(f"add Wants={ONLINE}", (line.end, f"\nWants={ONLINE}")),
            )
            break
