"""A line of sshd_config that comes too late: the first value wins.

## What it finds
A line whose keyword an earlier line, often in a drop-in, sets to another value. It is an error for settings
that keep people out, such as `PasswordAuthentication no`, and a warning for others.

## Why it matters on a robot
sshd uses the first value of a keyword. Debian and Ubuntu include sshd_config.d in the first line, so that
`PasswordAuthentication yes` in 50-cloud-init.conf overrides the `no` in sshd_config.

## Bad
```
# sshd_config.d/50-cloud-init.conf
PasswordAuthentication yes
# sshd_config, after its Include
PasswordAuthentication no
```

## Good
```
# sshd_config.d/00-robot.conf
PasswordAuthentication no
```

## When to ignore it
When the later line is a fallback for robots that do not have the drop-in.

## References
- sshd_config(5)
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
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


@rule("error", silent="sshd takes the first value without a message")
def overridden(robot: Robot) -> Iterator[Finding]:
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
                advice="delete one of the two, or move this setting to a drop-in that sorts first, such as "
                "00-robot.conf",
                related=[note(winner.keyword, f"sshd uses this value: {' '.join(winner.arguments)}")],
                severity=None if protects else "warning",
            )
