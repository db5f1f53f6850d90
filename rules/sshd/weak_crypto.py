"""sshd offers algorithms that are broken.

## What it finds
Ciphers, MACs, KexAlgorithms, HostKeyAlgorithms or PubkeyAcceptedAlgorithms with names such as 3des-cbc,
hmac-md5 or ssh-rsa.

## Why it matters on a robot
OpenSSH has switched them off for good reasons. Who can listen to or sit in the robot's radio link can
attack the connection.

## Bad
```
Ciphers aes256-ctr,3des-cbc
```

## Good
```
# the defaults of OpenSSH
```

## References
- sshd_config(5), "Ciphers"
- RFC 9142
"""

from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import rule


@rule("warning", tags=["CWE-327"])
def weak_crypto(robot: Robot):
    for sshd in robot.sshd:
        for name in sshd.weak_algorithms():
            if name.span.source.judged and not name.span.source.template:
                yield finding(name, f"{name} is weak", advice="delete it, or keep OpenSSH's defaults")
