"""A private key is in the repository.

## What it finds
`enclaves/.../key.pem`, or a key below `private` of a keystore, that is part of the repository. If the
repository has a git index, only files that git tracks are reported. Folders of tests and examples are
skipped.

## Why it matters on a robot
Everyone who can read the repository, or its history, can join the robot's network as the motor controller,
and with the authority's key create new identities for the whole fleet.

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

## When to ignore it
If the keystore is for simulation or continuous integration only and no robot trusts its authority.

## References
- ROS 2 documentation, "Deployment Guidelines" of security
"""

import re
from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import rule


@rule("error", tags=["CWE-321"])
def keystore_committed(robot: Robot) -> Iterator[Finding]:
    for source in robot.of_kind("sros2-key"):
        sample = re.search(r"(?:^|/)(?:tests?|fixtures?|examples?|samples?)/", source.name)
        if not source.judged or sample or not robot.sros2.ships(source):
            continue
        authority = "/private/" in f"/{source.name}"
        power = "create identities for the whole fleet" if authority else "use this identity on the robot's network"
        yield finding(
            source,
            f"A private key is in the repository: whoever reads it can {power}",
            advice="remove it from the history, ignore it, and create new keys",
        )
