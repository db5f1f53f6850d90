"""sshd allows more than a robot needs.

## What it finds
A setting that is open, by default in a complete configuration or because a line says so:

- X11Forwarding, AllowTcpForwarding or PermitTunnel is on;
- MaxAuthTries is above 4;
- ClientAliveInterval is not set;
- neither AllowUsers nor AllowGroups is set.

## Why it matters on a robot
Each of these opens a way into the robot's network, or keeps one open, that nobody uses.

## Bad
```
X11Forwarding yes
```

## Good
```
X11Forwarding no
AllowTcpForwarding no
PermitTunnel no
MaxAuthTries 3
ClientAliveInterval 300
AllowUsers robot-admin
```

## When to ignore it
When operators use the feature, for example TCP forwarding to reach a web interface on the robot, or X11
forwarding for a graphical tool.

## References
- sshd_config(5)
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import fix
from bringup_lint.api import rule
from bringup_lint.api.sshd import Sshd

SETTINGS = (
    ("X11Forwarding", "no", {"yes"}, "X11 forwarding is on", "no"),
    ("AllowTcpForwarding", "yes", {"yes", "all", "local", "remote"}, "TCP forwarding is on", "no"),
    ("PermitTunnel", "no", {"yes", "point-to-point", "ethernet"}, "Tunnel devices are allowed", "no"),
    (
        "ClientAliveInterval",
        "0",
        {"0", "0s"},
        "Dead connections stay open: there is no ClientAliveInterval",
        "300",
    ),
)
"""Keyword, default, values that are found, what they mean, what to write."""
MOST_TRIES = 4


@rule(
    "info",
    fix="unsafe",
    silent="sshd offers what it is told to",
    aliases=[
        "sshd/x11-forwarding",
        "sshd/tcp-forwarding",
        "sshd/permit-tunnel",
        "sshd/max-auth-tries",
        "sshd/client-alive-missing",
        "sshd/no-allowusers",
    ],
)
def hardening(robot: Robot) -> Iterator[Finding]:
    for sshd in robot.sshd:
        if not sshd.files:
            continue
        off = sshd.says("DisableForwarding", "no") == "yes"
        for name, default, open_values, what, better in SETTINGS:
            if sshd.says(name, default) in open_values and not (off and name != "ClientAliveInterval"):
                yield from found(sshd, name, what, better)
        tries = sshd.says("MaxAuthTries", "6")
        if tries is not None and tries.isdecimal() and int(tries) > MOST_TRIES:
            yield from found(sshd, "MaxAuthTries", f"A connection may try {tries} passwords or keys", "3")
        if sshd.is_whole and not sshd.all("AllowUsers") and not sshd.all("AllowGroups"):
            yield finding(sshd.where, "Every account may log in", advice="add AllowUsers with those that need it")


def found(sshd: Sshd, name: str, what: str, better: str) -> Iterator[Finding]:
    option = sshd.get(name)
    if option is None or option.span.source.judged:
        yield finding(
            option.value if option else sshd.where,
            what + ("" if option else " by default" if "no " not in what else ""),
            advice=f"set {name} {better}",
            fix=fix(f"set {name} {better}", (option.value, better)) if option else None,
        )
