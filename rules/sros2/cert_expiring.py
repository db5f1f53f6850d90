"""A certificate expires within 30 days.

## What it finds
A certificate of an enclave or of the authority whose last day is at most 30 days after the day of the run (or
after the day given with `--now`).

## Why it matters on a robot
After that day the participant is rejected, and the nodes no longer start.

## Bad
```text
notAfter=in twelve days
```

## Good
```text
notAfter=in a year
```

## When to ignore it
If certificates are deliberately short-lived and a job on the robot or in the fleet management renews them in
time.

## References
- RFC 5280, section 4.1.2.5
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import rule


@rule("warning", silent="the certificate is valid until that day")
def cert_expiring(robot: Robot) -> Iterator[Finding]:
    for source, certificate in robot.sros2.certificates:
        left = (certificate.last_day - robot.today).days
        if source.judged and 0 <= left <= 30:
            yield finding(
                source,
                f"The certificate expires in {left} day{'s' * (left != 1)}, on {certificate.last_day}: its nodes do "
                "not start after that",
                advice="create a new identity before that day, and sign its permissions again",
            )
