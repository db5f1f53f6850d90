"""A remote access service asks for no password.

## What it finds
A service that starts a desktop or shell server and switches authentication off, on all interfaces:

- code-server with `--auth none`, and ttyd without credentials;
- VNC servers and Jupyter, where host/unauthenticated-service does not report them, as in a simulation.

Servers that listen on this machine only are not reported.

## Why it matters on a robot
Everybody in the network of the robot, for example in the Wi-Fi of a trade fair, gets its desktop or a shell,
as the user of the service.

## Bad
```ini
[Service]
ExecStart=/usr/bin/ttyd bash
```

## Good
```ini
[Service]
ExecStart=/usr/bin/ttyd --credential rover:${TTYD_PASSWORD} bash
```

## When to ignore it
When a firewall or a tunnel is the only way to the port.

## References
- ttyd(1), --credential; code-server, `--auth`
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import rule
from bringup_lint.api.systemd import Offer
from bringup_lint.api.systemd import open_access

GIVES = {Offer.DESKTOP: "the desktop", Offer.NOTEBOOK: "a shell", Offer.TERMINAL: "a shell"}


@rule("error", symptoms=["- Authentication is disabled"], tags=["CWE-306"])
def no_authentication(robot: Robot) -> Iterator[Finding]:
    told = {each.where for each in robot.open_services}
    for unit in robot.units.services:
        for process in robot.units.processes(unit):
            for step in process.steps:
                found = open_access(step.command.words)
                if found is None or found.word.span in told:
                    continue
                yield finding(
                    found.word,
                    f"{found.program} of {unit.name} gives everybody in the network {GIVES[found.offer]}, "
                    "without a password",
                    advice=found.advice,
                )
