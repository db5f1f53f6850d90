"""Permissions are valid for more than 398 days.

## What it finds
A grant whose validity is longer than 398 days. sros2 writes ten years.

## Why it matters on a robot
A key that is copied from the robot works until its permissions expire: nothing else revokes it.

## Bad
```xml
<not_before>2026-01-01T00:00:00</not_before>
<not_after>2036-01-01T00:00:00</not_after>
```

## Good
```xml
<not_before>2026-01-01T00:00:00</not_before>
<not_after>2027-01-01T00:00:00</not_after>
```

## When to ignore it
If the robot cannot be reached for renewal during its service life, or an expired permission in the field is a
greater risk than a stolen key.

## References
- CA/Browser Forum Baseline Requirements, 6.3.2 (398 days)
- sros2, create_permission
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import note
from bringup_lint.api import rule
from bringup_lint.api.sros2 import moment


@rule("warning", tags=["CWE-324"])
def permissions_validity_too_long(robot: Robot) -> Iterator[Finding]:
    for _, grant in robot.sros2.ros_grants:
        start, end = moment(grant.not_before), moment(grant.not_after)
        days = (end - start).days if start and end else 0
        if days > 398:
            span = f"{round(days / 365.25)} years" if days > 700 else f"{days} days"
            yield finding(
                grant.not_after,
                f"{grant.enclave} is valid for {span}: a stolen key can be used that long",
                advice="sign permissions for at most a year, and renew them with a job on the signing machine",
                related=[note(grant.not_before, "the validity begins here")],
            )
