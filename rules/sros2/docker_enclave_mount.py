"""A single enclave is mounted in place of the keystore.

## What it finds
A compose service that mounts a folder below `enclaves` at the path of its `ROS_SECURITY_KEYSTORE`.

## Why it matters on a robot
rcl looks for `KEYSTORE/enclaves/...`, which does not exist there, and the enclave's links to
`../../../public` are broken: with Enforce no node starts.

## Bad
```yaml
volumes:
  - ./keystore/enclaves/lawn/driver:/keystore:ro
environment:
  ROS_SECURITY_KEYSTORE: /keystore
```

## Good
```yaml
volumes:
  - ./keystore/public:/keystore/public:ro
  - ./keystore/enclaves:/keystore/enclaves:ro
environment:
  ROS_SECURITY_KEYSTORE: /keystore
```

## When to ignore it
If the mounted folder is itself laid out as a keystore, with an `enclaves` folder of its own inside.

## References
- rcl, security.c; tested with the real rcl of Jazzy
"""

import re
from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import note
from bringup_lint.api import rule


@rule("error", symptoms=["SECURITY ERROR: directory"])
def docker_enclave_mount(robot: Robot) -> Iterator[Finding]:
    for service in robot.compose.services:
        variable = service.environment.get("ROS_SECURITY_KEYSTORE")
        value = variable.value if variable is not None else None
        keystore = value.rstrip("/") if value is not None else None
        if value is None or not keystore or "$" in keystore or not service.source.judged:
            continue
        for volume in service.volumes:
            inside = volume.source is not None and re.search(r"/enclaves/[^/]", volume.source)
            if inside and volume.target is not None and volume.target.rstrip("/") == keystore:
                yield finding(
                    volume.where,
                    f"rcl looks in {keystore}/enclaves, but {keystore} is a single enclave: the directory does not "
                    "exist, and its links are broken",
                    advice=f"mount public and enclaves of the keystore below {keystore}, read-only, without private",
                    related=[note(value, "the keystore is expected here")],
                )
