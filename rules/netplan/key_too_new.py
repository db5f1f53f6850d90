"""A key needs a newer netplan than the robot has.

## What it finds
A key or a value that needs a later netplan than the target release has:
- **warning**: no update of the release has it.
- **info**: the updates of the release have it.

The release is taken from the tree or from the configuration (`target`). If it is unknown, nothing is
reported.

## Why it matters on a robot
An older netplan does not skip a key that it does not know. It stops, and configures nothing.

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

## When to ignore it
If the robot has a newer netplan than its release, for example from a PPA or as a build of your own.

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
        for newer in file.newer:
            where, since = newer.where, newer.detail
            if _number(since) <= _number(first):
                continue
            after = _number(since) <= _number(updated)
            has = f"has {first}, with updates {updated}" if first != updated else f"has {first}"
            yield finding(
                where,
                f"{where} needs netplan {since}; {release} {has} ({robot.target.systemd_why})",
                advice="install the updates first" if after else "remove it, or set it in a networkd drop-in",
                severity="info" if after else None,
            )
