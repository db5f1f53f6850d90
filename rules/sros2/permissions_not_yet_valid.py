"""Permissions are not valid yet, or never will be.

## What it finds
A grant whose `not_before` is after the day of the run (or after the day given with `--now`), or not before
its `not_after`.

## Why it matters on a robot
The participant is rejected (code 148): the node does not start. A robot without a battery-backed clock boots
with a date in the past, and rejects all permissions until its time is set.

## Bad
```xml
<not_before>2027-01-01T00:00:00</not_before>
<not_after>2026-01-01T00:00:00</not_after>
```

## Good
```xml
<not_before>2026-01-01T00:00:00</not_before>
<not_after>2027-01-01T00:00:00</not_after>
```

## When to ignore it
If the permissions are prepared for a later date and are not deployed before it.

## References
- Cyclone DDS 0.10.5 with security, tested with the real library
- OMG DDS Security 1.1, clause 9.4.1.3
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import note
from bringup_lint.api import rule
from bringup_lint.api.sros2 import moment


@rule("error", symptoms=["Permissions validity period has not started yet"])
def permissions_not_yet_valid(robot: Robot) -> Iterator[Finding]:
    for _, grant in robot.sros2.grants:
        start, end = moment(grant.not_before), moment(grant.not_after)
        if start is None:
            continue
        if end is not None and start >= end:
            yield finding(
                grant.not_before or grant.place,
                "The validity ends before it begins: the participant is never accepted, the node does not start",
                advice="write the earlier date first, and sign the document again",
                related=[note(grant.not_after or grant.place, "the validity ends here")],
            )
        elif start.date() > robot.today:
            yield finding(
                grant.not_before or grant.place,
                f"The permissions are not valid before {start.date()} (code 148): the node does not start",
                advice="correct the date and sign the document again",
            )
