"""Several robots have the same SROS 2 key.

## What it finds
The private key of an enclave, or of the certificate authority of a keystore, that more than one robot has.

## Why it matters on a robot
An enclave's key is what a node proves its identity with. Where all robots have it, the loss of one robot is the loss
of all, and it cannot be shut out without a new key for each. With the key of the authority, whoever has one robot
makes identities and permissions for the whole fleet.

## Bad
```text
alpha/opt/keystore/private/ca.key.pem
beta/opt/keystore/private/ca.key.pem      the same key
```

## Good
```text
alpha/opt/keystore/enclaves/alpha/driver/key.pem
beta/opt/keystore/enclaves/beta/driver/key.pem    another key; no private/ on the robots
```

## When to ignore it
Never for the key of an authority. For an enclave, when the robots are stand-ins for each other and never run together.

## References
- [ROS 2 security enclaves](https://design.ros2.org/articles/ros2_security_enclaves.html)
- [The SROS 2 keystore: deployment](https://docs.ros.org/en/jazzy/Tutorials/Advanced/Security/Deployment-Guidelines.html)
"""

from collections.abc import Iterator

from bringup_lint.api import rule
from bringup_lint.api.fleet import Fleet
from bringup_lint.api.fleet import FleetFinding
from bringup_lint.api.fleet import fleet_finding
from bringup_lint.api.fleet import names


@rule("error", silent="both robots are accepted", tags=["CWE-321"])
def same_sros2_key(fleet: Fleet) -> Iterator[FleetFinding]:
    for group in fleet.shared("sros2-key", "sros2-ca"):
        authority = group[0].mark.kind == "sros2-ca"
        what = "private key of the certificate authority" if authority else "private key of an enclave"
        result = "makes identities for the whole fleet" if authority else "can pretend to be a node of any of them"
        yield fleet_finding(
            group,
            f"{len(group)} robots have the same {what}: {names(group)}; who reads it on one {result}",
            advice="keep private/ of the keystore off the robots, and make an enclave for each robot: ros2 security"
            " create_enclave",
        )
