"""network.target does not mean that the network is up.

## What it finds
A service that runs ROS 2, or whose environment configures DDS, and that is ordered after `network.target` (or
the network daemon) but not after `network-online.target`, either directly or through another unit. Exempt are
services of the user manager, services with a command that waits for the network, services limited to the local
machine, and those that only ask (`ros2 topic list`), because each question looks at the interfaces anew.

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

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Related
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import fix
from bringup_lint.api import note
from bringup_lint.api import rule
from bringup_lint.api.systemd import ONLINE
from bringup_lint.api.systemd import TooEarly
from bringup_lint.api.systemd import edits_to_wait
from bringup_lint.api.systemd import too_early


@rule(
    "warning",
    fix="unsafe",
    symptoms=["does not match an available interface", 'failed to find interfaces for "udp"'],
)
def network_target(robot: Robot) -> Iterator[Finding]:
    for early in too_early(robot.units):
        yield finding(
            early.word,
            f"{early.word} does not mean that any interface has an address: {early.unit.name} can start "
            f"before the network is up{'' if early.planned else ', and DDS checks the interfaces only once'}",
            advice=f"order after {ONLINE} and pull it in: Wants={ONLINE} and After={ONLINE}",
            related=list(_related(robot, early)),
            fix=fix(f"wait for {ONLINE}", *edits_to_wait(early, robot.units)),
            confidence="medium" if early.presumed else "high",
        )


def _related(robot: Robot, early: TooEarly) -> Iterator[Related]:
    for _, other in early.unit.naming("Wants", ONLINE):
        yield note(other, "pulled in here, but nothing waits for it")
    if early.presumed:
        outside = (process.script_outside_tree for process in robot.units.started(early.unit))
        yield from (
            note(script, "probably starts ROS 2: the script is not in this tree") for script in filter(None, outside)
        )
