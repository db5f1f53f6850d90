"""Permissions have expired.

## What it finds
A grant whose `not_after` is before the day of the run (or before the day given with `--now`).

## Why it matters on a robot
The participant is rejected (code 147): the node does not start after the next boot, on all robots that were
set up on the same day.

## Bad
```xml
<not_after>2020-01-01T00:00:00</not_after>
```

## Good
```xml
<not_after>2027-01-01T00:00:00</not_after>
```

## When to ignore it
If the document is a sample or a test fixture that no robot uses.

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


@rule("error", symptoms=["Permissions validity period expired for"], tags=["CWE-298"])
def permissions_expired(robot: Robot) -> Iterator[Finding]:
    for _, grant in robot.sros2.grants:
        end = moment(grant.not_after)
        if end is not None and end.date() < robot.today:
            yield finding(
                grant.not_after or grant.place,
                f"The permissions expired on {end.date()}: the participant is rejected (code 147), the node does not "
                "start",
                advice="extend the validity of the grant and sign the document again",
            )
