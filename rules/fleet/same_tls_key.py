"""Several robots have the same private TLS key.

## What it finds
A private key in PEM, of a web interface, an MQTT client or anything else that speaks TLS, that more than one robot
has.

## Why it matters on a robot
A broker or a fleet server cannot tell the robots apart, and one lost robot gives away the traffic of all. To shut it
out, every robot needs a new key.

## Bad
```text
alpha/etc/mosquitto/certs/client.key   the key of the image
beta/etc/mosquitto/certs/client.key    the same
```

## Good
```text
alpha/etc/mosquitto/certs/client.key   made on alpha
beta/etc/mosquitto/certs/client.key    made on beta
```

## When to ignore it
For a key that only signs for tests and is trusted by nobody.

## References
- [RFC 7925](https://www.rfc-editor.org/rfc/rfc7925): TLS profiles for the Internet of Things
- CWE-321: use of a hard-coded cryptographic key
"""

from collections.abc import Iterator

from bringup_lint.api import rule
from bringup_lint.api.fleet import Fleet
from bringup_lint.api.fleet import FleetFinding
from bringup_lint.api.fleet import fleet_finding
from bringup_lint.api.fleet import names


@rule("error", silent="both robots are accepted", tags=["CWE-321"])
def same_tls_key(fleet: Fleet) -> Iterator[FleetFinding]:
    for group in fleet.shared("tls-key"):
        yield fleet_finding(
            group,
            f"{len(group)} robots have the same private key ({group[0].mark.name}): {names(group)}; one lost robot"
            " gives away all of them",
            advice="make the key on the robot and have its certificate signed, so that no key travels",
        )
