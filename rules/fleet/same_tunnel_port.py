"""Several robots open the same port on one server.

## What it finds
A port that `ssh -R` opens on a server, in scripts and units of more than one robot.

## Why it matters on a robot
The server gives the port to the robot that comes first. For all others ssh says "remote port forwarding failed" and, as
a rule, stays connected without the tunnel: support reaches the wrong robot, or none.

## Bad
```sh
# alpha and beta
ssh -N -R 2222:localhost:22 tunnel@support.example.com
```

## Good
```sh
# alpha; beta has 2223
ssh -N -R 2222:localhost:22 tunnel@support.example.com
```

## When to ignore it
When only one of the robots opens its tunnel at a time.

## References
- ssh(1), `-R`
- ssh_config(5), `ExitOnForwardFailure`
"""

from collections.abc import Iterator

from bringup_lint.api import rule
from bringup_lint.api.fleet import Fleet
from bringup_lint.api.fleet import FleetFinding
from bringup_lint.api.fleet import fleet_finding
from bringup_lint.api.fleet import names


@rule("error", symptoms=["remote port forwarding failed for listen port"])
def same_tunnel_port(fleet: Fleet) -> Iterator[FleetFinding]:
    for group in fleet.alike("tunnel"):
        server, port = group[0].fact.key, group[0].fact.value
        yield fleet_finding(
            group,
            f"{len(group)} robots open port {port} on {server}: {names(group)}; only the first one gets it",
            advice="give each robot a port of its own, and set ExitOnForwardFailure=yes so that the loss is seen",
        )
