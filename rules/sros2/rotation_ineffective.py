"""A script that should rotate keys does not replace them.

## What it finds
A script whose name or text mentions rotating or renewing, and that calls `ros2 security create_enclave`
without removing keys or enclaves first.

## Why it matters on a robot
`create_enclave` does not change the certificate and key of an existing enclave, and replaces its permissions
with ones that allow everything: least privilege is lost and the stolen key still works.

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

## When to ignore it
If the script only creates enclaves that do not exist yet, and another one renews them.

## References
- sros2, create_enclave, tested with the real tool
"""

import re
from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import rule


@rule("error", silent="create_enclave keeps an existing certificate without a message")
def rotation_ineffective(robot: Robot) -> Iterator[Finding]:
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
                    "The rotation has no effect: an existing enclave keeps its certificate and key, and its "
                    "permissions become 'allow everything'",
                    advice="remove cert.pem and key.pem first, and run create_permission with the policy afterwards",
                )
