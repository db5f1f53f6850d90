"""A line of sshd_config that comes too late: the first value wins.

## What it finds
A keyword that an earlier line, often in a drop-in, has set to something else. It is an error for the
settings that keep people out.

## Why it matters on a robot
sshd takes the first value of a keyword. Debian and Ubuntu include sshd_config.d in the first line, so that
50-cloud-init.conf with `PasswordAuthentication yes` beats the line in sshd_config that says no.

## Bad
```
# sshd_config.d/50-cloud-init.conf
PasswordAuthentication yes
# sshd_config, behind its Include
PasswordAuthentication no
```

## Good
```
# sshd_config.d/00-robot.conf
PasswordAuthentication no
```

## References
- sshd_config(5)
"""

from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import note
from bringup_lint.api import rule

PROTECTS = {
    "PasswordAuthentication": {"no"},
    "KbdInteractiveAuthentication": {"no"},
    "PermitRootLogin": {"no", "prohibit-password", "without-password", "forced-commands-only"},
    "PermitEmptyPasswords": {"no"},
    "PubkeyAuthentication": {"yes"},
    "AllowTcpForwarding": {"no"},
    "X11Forwarding": {"no"},
    "PermitTunnel": {"no"},
    "DisableForwarding": {"yes"},
}


@rule("error")
def overridden(robot: Robot):
    for sshd in robot.sshd:
        for option, winner in sshd.overridden():
            source = option.span.source
            if not source.judged or source.template or winner.span.source.template:
                continue
            protects = option.value.lower() in PROTECTS.get(option.name, ())
            yield finding(
                option.keyword,
                f"{winner.span.source.basename}:{winner.keyword.line} sets {option.name} first: this line has no "
                "effect",
                advice="delete one of the two; what must win belongs into a drop-in that sorts first, such as "
                "00-robot.conf",
                related=[note(winner.keyword, f"this value counts: {' '.join(winner.arguments)}")],
                severity=None if protects else "warning",
            )
