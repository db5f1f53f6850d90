"""A script disables the service that waits for the network.

## What it finds
`systemctl mask` or `disable` of `systemd-networkd-wait-online.service` or `NetworkManager-wait-online.service` in a
script of a robot whose units start ROS at boot, when no other wait service is enabled by the tree. It is a warning
where a unit with ROS is ordered after network-online.target. Where the units only come after network.target or the
like, the mask changes nothing yet, and it is info.

## Why it matters on a robot
network-online.target is reached at once when nothing waits. `After=network-online.target` is then an empty word: DDS
looks at the interfaces once, before they have addresses, and the nodes of the robot are not found from outside until
somebody restarts them.

## Bad
```sh
sudo systemctl mask systemd-networkd-wait-online.service
```

## Good
```sh
sudo systemctl edit systemd-networkd-wait-online.service
# [Service]
# ExecStart=
# ExecStart=/lib/systemd/systemd-networkd-wait-online --interface=eth0 --timeout=30
```

## When to ignore it
When NetworkManager has the interfaces and its own wait service is enabled, or when the units wait for an address
themselves.

## References
- systemd.special(7), "network-online.target"
- systemd-networkd-wait-online.service(8)
"""

import re
from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Located
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import note
from bringup_lint.api import regex
from bringup_lint.api import rule
from bringup_lint.api.systemd import too_early

WAITER = regex(r"(?P<daemon>systemd-networkd|NetworkManager)-wait-online(?:\.service)?")
ONLINE = "network-online.target"


@rule("warning", symptoms=["does not match an available interface"])
def wait_online_masked(robot: Robot) -> Iterator[Finding]:
    for _, run in robot.scripts.run("systemctl"):
        verb = next((word for word in run.arguments if word in ("mask", "disable")), "")
        word = next((word for word in run.words[1:] if WAITER.fullmatch(word)), None)
        if not verb or word is None or _other_waits(robot, word):
            continue
        waiting = [(unit.name, after) for unit in robot.units.dds for after in unit.words("After") if after == ONLINE]
        if waiting:
            yield _finding(
                word,
                f"Nothing waits for the network any more: {ONLINE} is reached at once, and DDS of {waiting[0][0]} "
                "may start before any interface has an address",
                waiting,
            )
            continue
        early = [(each.unit.name, each.word) for each in too_early(robot.units) if not each.presumed]
        if early:
            yield _finding(
                word,
                f"{ONLINE} waits for nothing any more: After={ONLINE} would not make {early[0][0]} wait for an address",
                early,
                severity="info",
            )


def _finding(word: Located, message: str, units: list[tuple[str, Located]], severity: str | None = None) -> Finding:
    return finding(
        word,
        message,
        advice="limit the wait instead: a drop-in with --interface=eth0 --timeout=30",
        related=[note(place, f"{name} starts at boot") for name, place in units[:3]],
        confidence="medium",
        severity=severity,
    )


def _other_waits(robot: Robot, word: str) -> bool:
    """Whether the other network daemon waits, as far as the tree says that there is one."""
    masked = WAITER.fullmatch(word)
    if masked is not None and masked["daemon"] == "NetworkManager":
        return bool(robot.of_kind("netplan"))
    return robot.mentions(re.compile(r"renderer:\s*NetworkManager|\bnmcli\b|NetworkManager-wait-online"))
