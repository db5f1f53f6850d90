"""An SSH tunnel cannot carry DDS.

## What it finds
`ssh -L` or `ssh -R` with a DDS port: one of the first 51 ports of domain 0 (7400 to 7450) or of the domain that the
tree sets.

## Why it matters on a robot
SSH forwards only TCP, but DDS discovery and data use UDP. The tunnel is established and carries nothing.

## Bad
```sh
ssh -N -L 7400:localhost:7400 robot@robot-7
```

## Good
```sh
# a VPN, or zenoh-bridge-ros2dds over TCP
```

## When to ignore it
When a TCP service listens on this port, for example DDS over TCP or a discovery server with a TCP transport.

## References
- ssh(1), -L
- DDSI-RTPS 2.5, section 9.6.2
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import rule


@rule("error", silent="ssh forwards TCP connections; the UDP packets of DDS never enter the tunnel")
def ssh_tunnel_udp(robot: Robot) -> Iterator[Finding]:
    for _, port, where in robot.ssh_forwards:
        domain = robot.dds_domain[0] if robot.dds_domain else 0
        bases = {7400, 7400 + 250 * domain}
        if any(base <= port <= base + 50 for base in bases):
            yield finding(
                where,
                f"SSH forwards only TCP, but port {port} is DDS over UDP: the tunnel carries nothing",
                advice="use a VPN, a zenoh bridge or a DDS router over TCP",
            )
