"""fail2ban blocks a port on which sshd does not listen.

## What it finds
A `port` of the jail `[sshd]` that contains none of the `Port` settings of the sshd configuration on the same robot.

## Why it matters on a robot
Attackers are banned from a port that nobody uses, and continue on the real one.

## Bad
```ini
[sshd]
port = 22            # sshd_config: Port 2222
```

## Good
```ini
[sshd]
port = 2222          # sshd_config: Port 2222
```

## When to ignore it
When a router forwards the port of the jail to the port of sshd, and fail2ban bans on the router.

## References
- jail.conf(5)
- robotics-security guide
"""

import re
from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import fix
from bringup_lint.api import note
from bringup_lint.api import regex
from bringup_lint.api import rule

NAMES = {"ssh": "22"}
PORT = regex(r"^[ \t]*Port[ \t=]+(\d+)", re.M | re.I)


@rule("warning", fix="unsafe", silent="fail2ban reports the ban, not the port that stays open")
def fail2ban_port_mismatch(robot: Robot) -> Iterator[Finding]:
    ports = [source.located(*match.span(1)) for source in robot.sshd_sources for match in PORT.finditer(source.text)]
    for jail in robot.jails:
        port = jail.get("sshd", "port")
        if not robot.sshd_sources or port is None or jail.get("sshd", "enabled") == "false" or "%" in port:
            continue
        blocked = {NAMES.get(name.strip(), name.strip()) for name in port.split(",")}
        listens = {str(place) for place in ports} or {"22"}
        if blocked & listens or any(":" in name or not name.isdecimal() for name in blocked):
            continue
        new = ",".join(sorted(listens))
        yield finding(
            port,
            f"fail2ban blocks port {port}, but sshd listens on {new}",
            advice=f"write port = {new}",
            related=[note(place, "sshd listens here") for place in ports],
            fix=fix(f"write {new}", (port, new)),
        )
