"""SSH accepts passwords.

## What it finds
An effective `PasswordAuthentication yes`. It is a warning when a complete configuration does not set it,
because the default is yes. Configurations with AuthenticationMethods are not checked.

## Why it matters on a robot
Robot passwords are short, shared and the same on every robot. Anyone who reaches the network can try them
all.

## Bad
```
PasswordAuthentication yes
```

## Good
```
PasswordAuthentication no
KbdInteractiveAuthentication no
```

## When to ignore it
On a development robot in a closed network, or during the first setup, before the keys are installed.

## References
- sshd_config(5), "PasswordAuthentication"
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import fix
from bringup_lint.api import rule


@rule(
    "error",
    fix="unsafe",
    tags=["CWE-287", "CWE-307"],
    symptoms=["Accepted password for", "Failed password for invalid user", "Failed password for"],
)
def password_auth(robot: Robot) -> Iterator[Finding]:
    for sshd in robot.sshd:
        if not sshd.files or sshd.says("PasswordAuthentication", "yes") != "yes" or sshd.get("AuthenticationMethods"):
            continue
        option = sshd.get("PasswordAuthentication")
        if option is not None and not option.span.source.judged:
            continue
        yield finding(
            option.value if option else sshd.where,
            "SSH accepts passwords"
            + ("" if option else ": nothing sets PasswordAuthentication, and the default is yes"),
            advice="set PasswordAuthentication no once the keys are installed",
            fix=fix("set PasswordAuthentication no", (option.value, "no")) if option else None,
            severity=None if option else "warning",
        )
