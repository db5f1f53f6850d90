"""After=network-online.target, but nothing pulls in the target.

## What it finds
A unit ordered after `network-online.target` that nothing pulls in: neither the unit, a unit that it depends
on, nor another unit of the tree has `Wants=` or `Requires=` of it.
Exempt are units with a command that waits for the network itself.

## Why it matters on a robot
`network-online.target` is not part of a normal boot: nothing starts it unless a unit pulls it in. An order
after a unit that does not start has no effect, so that the service starts at once, before the interfaces have
addresses. `systemd-analyze verify` does not report it.

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

## When to ignore it
When a package outside of this tree always pulls in the target, for example cloud-init or an NFS mount.

## References
- systemd.special(7), "network-online.target"
- <https://systemd.io/NETWORK_ONLINE/>
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import fix
from bringup_lint.api import rule
from bringup_lint.api.systemd import waits_itself

ONLINE = "network-online.target"


@rule("warning", fix="unsafe", symptoms=["does not match an available interface", "Network is unreachable"])
def network_online_no_wants(robot: Robot) -> Iterator[Finding]:
    units = robot.units
    for unit in units.judged:
        for line, word in unit.naming("After", ONLINE):
            if unit.manager == "user" or unit.unsure_of("Wants", "Requires"):
                continue
            if units.brings_in(unit, ONLINE) or units.brought_in(unit, ONLINE) or waits_itself(unit, units):
                continue
            needed = f"add Wants={ONLINE}, or remove this After= where nothing needs the network"
            needless = f"remove this After=, or add Wants={ONLINE} where its start needs an address"
            yield finding(
                word,
                f"{unit.name} does not pull in {ONLINE}, and nothing else in this tree does: unless an installed "
                "package pulls it in, this After= has no effect, and the start does not wait for the network",
                advice=needed if unit in units.dds else needless,
                fix=fix(f"add Wants={ONLINE}", (line.end, f"\nWants={ONLINE}")),
            )
            break
