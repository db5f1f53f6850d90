"""A rotation of keys that rotates nothing.

## What it finds
A script that rotates or renews, calls `ros2 security create_enclave`, and removes neither keys nor enclaves
before.

## Why it matters on a robot
`create_enclave` leaves the certificate and key of an existing enclave as they are, and replaces its permissions
by ones that allow everything: least privilege is gone and the stolen key still works.

## Bad
```sh
ros2 security create_enclave /etc/lawn/keystore /lawn/driver
```

## Good
```sh
rm /etc/lawn/keystore/enclaves/lawn/driver/cert.pem /etc/lawn/keystore/enclaves/lawn/driver/key.pem
ros2 security create_enclave /etc/lawn/keystore /lawn/driver
ros2 security create_permission /etc/lawn/keystore /lawn/driver policy.xml
```

## References
- sros2, create_enclave, tried with the real tool
"""

import re

from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import rule


@rule("error")
def rotation_ineffective(robot: Robot):
    for source, commands in robot.sros2.scripts("create_enclave"):
        if not re.search(r"rotat|renew|refresh|expir", source.name + source.text, re.I):
            continue
        removed = False
        for command in commands:
            removed |= command.name in ("rm", "mv", "find", "shred", "unlink", "create_keystore")
            removed |= "create_keystore" in command.words
            words = [str(word) for word in command.words]
            if not removed and words[:2] == ["ros2", "security"] and "create_enclave" in words:
                yield finding(
                    command.words[words.index("create_enclave")],
                    "The rotation does nothing: an existing enclave keeps its certificate and key, and its "
                    "permissions become 'allow everything'",
                    advice="remove cert.pem and key.pem first, and run create_permission with the policy afterwards",
                )
