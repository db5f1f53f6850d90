"""sshd offers algorithms that are broken.

## What it finds
Ciphers, MACs, KexAlgorithms, HostKeyAlgorithms or PubkeyAcceptedAlgorithms with broken algorithms such as
3des-cbc, hmac-md5 or ssh-rsa.

## Why it matters on a robot
OpenSSH disables these algorithms by default because they can be broken. An attacker within radio range of the
robot can attack the connection.

## Bad
```
Ciphers aes256-ctr,3des-cbc
```

## Good
```
# the defaults of OpenSSH
```

## When to ignore it
When a device that cannot be updated, such as an old PLC, must connect to the robot over a network of its own.

## References
- sshd_config(5), "Ciphers"
- RFC 9142
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import rule


@rule(
    "warning",
    tags=["CWE-327"],
    symptoms=[
        "no matching cipher found. Their offer: 3des-cbc",
        "no matching host key type found. Their offer: ssh-rsa",
    ],
)
def weak_crypto(robot: Robot) -> Iterator[Finding]:
    for sshd in robot.sshd:
        for name in sshd.weak_algorithms():
            if name.span.source.judged and not name.span.source.template:
                yield finding(name, f"sshd offers {name}, which is weak", advice="delete it, or use OpenSSH's defaults")
