"""Private keys in the repository.

## What it finds
`enclaves/.../key.pem` or a key below `private` of a keystore that goes with the repository. With git at hand,
only what git tracks counts. Folders of tests and examples are left out.

## Why it matters on a robot
Everybody who can read the repository, or its history, can join the robot's network as the motor controller,
and with the CA's key make new identities for the whole fleet.

## Bad
```text
keystore/private/ca.key.pem
keystore/enclaves/lawn/driver/key.pem
```

## Good
```text
keystore/public/ca.cert.pem
keystore/enclaves/lawn/driver/permissions.xml
```

## References
- ROS 2 documentation, "Deployment Guidelines" of security
"""

import re

from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import rule


@rule("error", tags=["CWE-321"])
def keystore_committed(robot: Robot):
    for source in robot.of_kind("sros2-key"):
        sample = re.search(r"(?:^|/)(?:tests?|fixtures?|examples?|samples?)/", source.name)
        if not source.judged or sample or not robot.sros2.ships(source):
            continue
        authority = "/private/" in f"/{source.name}"
        power = "make identities for the whole fleet" if authority else "take this identity on the robot's network"
        yield finding(
            source,
            f"A private key is in the repository: whoever reads it can {power}",
            advice="remove it from the history, ignore it, and create new keys",
        )
