"""The boot waits for the network without a limit.

## What it finds
`systemd-networkd-wait-online` with `--timeout=0`, which means no limit, in a drop-in of the distribution's
unit or in another service.

## Why it matters on a robot
If one interface has no link, such as a spare port or a camera that is off, systemd never reaches
`network-online.target`. No unit that waits for it starts. The robot looks dead and needs a screen and a
keyboard.

## Bad
```ini
# systemd-networkd-wait-online.service.d/forever.conf
[Service]
ExecStart=
ExecStart=/usr/lib/systemd/systemd-networkd-wait-online --timeout=0
```

## Good
```ini
# systemd-networkd-wait-online.service.d/lidar.conf
[Service]
ExecStart=
ExecStart=/usr/lib/systemd/systemd-networkd-wait-online --interface=eth0 --timeout=30
```

## When to ignore it
When the robot is useless without the network, and `--interface=` names only interfaces that are always
connected.

## References
- systemd-networkd-wait-online.service(8)
- <https://github.com/systemd/systemd/issues/30345>
"""

import itertools
from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import regex
from bringup_lint.api import rule

WAITER = regex(r"(?:^|/)systemd-networkd-wait-online$", hints="wait-online")
FOREVER = regex(r"--timeout=0$")


@rule("warning", symptoms=["A start job is running for Wait for Network to be Configured"])
def wait_online_unbounded(robot: Robot) -> Iterator[Finding]:
    for unit in robot.units.running("systemd-networkd-wait-online"):
        for process in robot.units.started(unit):
            if not WAITER.search(process.program):
                continue
            words = process.argv[1:]
            forever = [word for word in words if FOREVER.search(word)]
            forever += [second for first, second in itertools.pairwise(words) if first == "--timeout" and second == "0"]
            if forever:
                yield finding(
                    forever[0],
                    f"{unit.name} waits forever: if one interface has no link, no unit after "
                    "network-online.target starts",
                    advice="set a limit (--timeout=30), and name the interfaces that must be up (--interface=)",
                )
