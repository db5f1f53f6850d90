"""Permissions are valid for more than 398 days.

## What it finds
A grant whose validity is longer than 398 days. The enclaves of a keystore are one finding. The ten years that
sros2 writes by itself are an info.

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
from bringup_lint.api.sros2 import Grant
from bringup_lint.api.sros2 import moment

OF_TOOL = range(3649, 3655)
"""Days: ``ros2 security`` signs for ten years."""


@rule("warning", silent="the permissions are valid", tags=["CWE-324"])
def permissions_validity_too_long(robot: Robot) -> Iterator[Finding]:
    keystores: dict[str, list[Grant]] = {}
    for document, grant in robot.sros2.ros_grants:
        if _days(grant) > 398:
            keystores.setdefault(document.source.name.partition("enclaves/")[0], []).append(grant)
    for first, *others in keystores.values():
        days = _days(first)
        span = f"{round(days / 365.25)} years" if days > 700 else f"{days} days"
        who = f"{first.enclave} is"
        if others:
            who = (
                f"{first.enclave} and {others[0].enclave if len(others) == 1 else f'{len(others)} other enclaves'} are"
            )
        yield finding(
            first.not_after or first.place,
            f"{who} valid for {span}: a stolen key can be used that long",
            severity="info" if _days(first) in OF_TOOL else None,
            advice="sign permissions for at most a year, and renew them with a job on the signing machine",
            related=[
                note(first.not_before or first.place, "the validity begins here"),
                *(note(each.not_after or each.place, f"the same for {each.enclave}") for each in others),
            ],
        )


def _days(grant: Grant) -> int:
    start, end = moment(grant.not_before), moment(grant.not_after)
    return (end - start).days if start and end else 0
