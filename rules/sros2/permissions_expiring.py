"""Permissions expire within 30 days.

## What it finds
A grant whose `not_after` is at most 30 days after the day of the run (or after the day given with `--now`).

## Why it matters on a robot
After that day the participant is rejected (code 147) and the node no longer starts.

## Bad
```xml
<not_after>2026-06-10T00:00:00</not_after>
```

## Good
```xml
<not_after>2027-06-01T00:00:00</not_after>
```

## When to ignore it
If permissions are deliberately short-lived and a job renews and deploys them in time.

## References
- Cyclone DDS 0.10.5 with security, tested with the real library
- OMG DDS Security 1.1, clause 9.4.1.3
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import rule
from bringup_lint.api.sros2 import moment


@rule("warning", silent="the permissions are valid until that day")
def permissions_expiring(robot: Robot) -> Iterator[Finding]:
    for _, grant in robot.sros2.grants:
        end = moment(grant.not_after)
        if end is None:
            continue
        left = (end.date() - robot.today).days
        if 0 <= left <= 30:
            yield finding(
                grant.not_after or grant.place,
                f"The permissions expire in {left} day{'s' * (left != 1)}, on {end.date()}: the node does not start "
                "after that",
                advice="renew the grant and sign the document again",
            )
