"""A certificate has expired.

## What it finds
A certificate of an enclave or of the authority whose last day is before the day of the run (or before the day
given with `--now`).

## Why it matters on a robot
The participant is rejected: no node of the enclave starts. With the authority's certificate, no node starts
at all.

## Bad
```text
notAfter=Jan  1 00:00:00 2020 GMT
```

## Good
```text
notAfter=Jan  1 00:00:00 2036 GMT
```

## When to ignore it
If the keystore is a test fixture or a sample that no robot uses.

## References
- RFC 5280, section 4.1.2.5
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import rule


@rule("error", tags=["CWE-298"], symptoms=["certificate has expired"])
def cert_expired(robot: Robot) -> Iterator[Finding]:
    for source, certificate in robot.sros2.certificates:
        if source.judged and certificate.last_day < robot.today:
            yield finding(
                source,
                f"The certificate expired on {certificate.last_day}: participants that use it are rejected, their "
                "nodes do not start",
                advice="create a new identity, and sign its permissions again",
            )
