"""A netplan key is newer than the netplan of the robot.

## What it finds
A key or a value that came with a later netplan than the one the target release has. The release is taken
from the tree or from the configuration (`target`); when it is unknown, nothing is said.

## Why it matters on a robot
An older netplan does not skip what it does not know: it stops, and nothing is configured.

## Bad
```yaml
# Ubuntu 22.04: netplan 0.104, with updates 0.107.1
ra-overrides:
  use-dns: false
```

## Good
```yaml
# set in a systemd-networkd drop-in, or on Ubuntu 24.04 with updates
ra-overrides:
  use-dns: false
```

## References
- netplan release notes; the packages of Ubuntu 22.04 and 24.04 and of Debian 12
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import rule

RELEASES = {
    249: ("Ubuntu 22.04", "0.104", "0.107.1"),
    252: ("Debian 12", "0.106", "0.106"),
    255: ("Ubuntu 24.04", "1.0", "1.1.2"),
}
"""Release by its systemd, with the netplan at release and after updates."""


def _number(version: str) -> tuple[int, ...]:
    return tuple(int(part) for part in version.split("."))


@rule("warning", symptoms=["Error in network definition: unknown key"])
def key_too_new(robot: Robot) -> Iterator[Finding]:
    if not robot.target.systemd_known or robot.target.systemd not in RELEASES:
        return
    release, first, updated = RELEASES[robot.target.systemd]
    for file in robot.netplan.files:
        for _, where, since in file.newer:
            if _number(since) <= _number(first):
                continue
            after = _number(since) <= _number(updated)
            has = f"has {first}, with updates {updated}" if first != updated else f"has {first}"
            yield finding(
                where,
                f"{where} needs netplan {since}; {release} {has} ({robot.target.systemd_why})",
                advice="install the updates first" if after else "leave it out or set it in a networkd drop-in",
                severity="info" if after else None,
            )
