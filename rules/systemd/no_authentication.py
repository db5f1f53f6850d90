"""A remote access service asks for no password.

## What it finds
A service that starts a desktop or shell server and switches authentication off, on all interfaces:

- VNC: `-SecurityTypes None` of TigerVNC, `-nopw` of x11vnc;
- Jupyter with an empty token, or `--ip` for all interfaces without one;
- code-server with `--auth none`, and ttyd or shellinabox without credentials.

Servers that listen on this machine only are not reported.

## Why it matters on a robot
Everybody in the network of the robot, for example in the Wi-Fi of a trade fair, gets its desktop or a shell,
as the user of the service.

## Bad
```ini
[Service]
ExecStart=/usr/bin/x0vncserver -display :0 -SecurityTypes=None
```

## Good
```ini
[Service]
ExecStart=/usr/bin/x0vncserver -display :0 -PasswordFile=/etc/vnc/passwd
```

## When to ignore it
When a firewall or a tunnel is the only way to the port.

## References
- x0vncserver(1), -SecurityTypes; x11vnc(1), -nopw
- Jupyter: "Security in the Jupyter Server"
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import rule
from bringup_lint.api.systemd import open_access


@rule("error", tags=["CWE-306"])
def no_authentication(robot: Robot) -> Iterator[Finding]:
    told = {each.where for each in robot.open_services}
    for unit in robot.units.services:
        for process in robot.units.processes(unit):
            for found in open_access(process):
                if found.word.span in told:
                    continue
                yield finding(
                    found.word,
                    f"{found.program} of {unit.name} gives everybody in the network {found.what}, without a password",
                    advice=found.advice,
                )
