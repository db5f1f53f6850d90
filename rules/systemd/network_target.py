"""network.target does not mean that the network is up.

## What it finds
A service that runs ROS 2, or whose environment configures DDS, and that is ordered after `network.target` (or
the network daemon) but not after `network-online.target`, either directly or through another unit. Exempt are
services of the user manager, services with a command that waits for the network, and services limited to the
local machine.

A service of a ROS 2 tree whose script is not in the tree is reported with medium confidence.

## Why it matters on a robot
systemd reaches `network.target` as soon as the network daemon runs. No interface needs to have an address by
then. DDS checks the interfaces once, when the first node starts. CycloneDDS fails if an interface in its
configuration is missing. Fast DDS continues with the loopback interface alone and does not use interfaces
that appear later. This works on the bench, where the cable is plugged in and DHCP is fast, and fails on some
boots of the robot.

## Bad
```ini
[Unit]
After=network.target
```

## Good
```ini
[Unit]
Wants=network-online.target
After=network-online.target
```

## When to ignore it
When the nodes communicate only within this machine, or when a node or the middleware itself waits for the
interface.

## References
- systemd.special(7), "network.target" and "network-online.target"
- <https://systemd.io/NETWORK_ONLINE/>
- <https://github.com/eProsima/Fast-DDS/issues/1880>
"""

import re
from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Located
from bringup_lint.api import Robot
from bringup_lint.api import Span
from bringup_lint.api import finding
from bringup_lint.api import fix
from bringup_lint.api import note
from bringup_lint.api import rule
from bringup_lint.api.systemd import Assignment
from bringup_lint.api.systemd import Unit
from bringup_lint.api.systemd import Units

ONLINE = "network-online.target"
EARLY = ("network.target", "network-pre.target", "NetworkManager.service", "systemd-networkd.service")
WAITS = re.compile(
    r"wait-online|nm-online|\bping\b|wait[-_ ]?for[-_ ]?(?:the[-_ ])?(?:net|ip\b|interface)"
    r"|\bip (?:-\S+ )*(?:a|addr|route)\b"
)


@rule(
    "warning",
    fix="safe",
    symptoms=["does not match an available interface", 'failed to find interfaces for "udp"'],
)
def network_target(robot: Robot) -> Iterator[Finding]:
    units = robot.units
    for unit in (*units.dds, *units.presumed_ros):
        lines = [
            *unit.naming("After", *EARLY),
            *unit.naming("Wants", *EARLY),
            *unit.naming("Requires", *EARLY),
        ]
        if not lines or unit.manager == "user" or unit.unsure_of("After", "Wants", "Requires"):
            continue
        if units.waits_for(unit, ONLINE) or units.stays_local(unit):
            continue
        if any(WAITS.search(text) for process in units.processes(unit) for text in process.texts):
            continue
        line, word = lines[0]
        known = unit in units.dds
        lost = [process.lost_script for process in units.started(unit) if process.lost_script]
        yield finding(
            word,
            f"{word} does not mean that any interface has an address: {unit.name} can start "
            "before the network is up, and DDS checks the interfaces only once",
            advice=f"order after {ONLINE} and pull it in: Wants={ONLINE} and After={ONLINE}",
            related=[
                *(note(other, "pulled in here, but nothing waits for it") for _, other in unit.naming("Wants", ONLINE)),
                *(
                    note(script, "probably starts ROS 2: the script is not in this tree")
                    for script in lost
                    if not known
                ),
            ],
            fix=fix(f"wait for {ONLINE}", *_edits(units, unit, line, word)),
            confidence="high" if known else "medium",
        )


def _edits(
    units: Units, unit: Unit, line: Assignment, word: Located
) -> Iterator[tuple[Located, str] | tuple[Span, str]]:
    ordered = list(unit.naming("After", word))
    if word == "network.target":
        yield word, ONLINE
        missing = [] if ordered else [f"After={ONLINE}"]
    else:
        missing = [f"After={ONLINE}"]
    if not units.brings_in(unit, ONLINE) and (ordered or word != "network.target"):
        missing.insert(0, f"Wants={ONLINE}")
    if missing:
        yield line.end, "".join(f"\n{text}" for text in missing)
