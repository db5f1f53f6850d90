"""A certificate that ends within 30 days.

## What it finds
A certificate of an enclave or of the authority whose last day lies within 30 days of the day of the run (or the
day given with `--now`).

## Why it matters on a robot
From that day on the participant is rejected, and the nodes do not start any more.

## Bad
```text
notAfter=in twelve days
```

## Good
```text
notAfter=in a year
```

## References
- RFC 5280, section 4.1.2.5
"""

from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import rule


@rule("warning")
def cert_expiring(robot: Robot):
    for source, certificate in robot.sros2.certificates:
        left = (certificate.last_day - robot.today).days
        if source.judged and 0 <= left <= 30:
            yield finding(
                source,
                f"The certificate expires in {left} day{'s' * (left != 1)}, on {certificate.last_day}: its nodes do "
                "not start after that",
                advice="create a new identity before, and sign its permissions again",
            )
