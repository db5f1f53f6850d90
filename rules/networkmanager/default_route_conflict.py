"""Two profiles make default routes with the same metric.

## What it finds
Two static profiles of one folder that come up on different interfaces, each with a gateway and without
`never-default=true`, and with the same metric: the one that both write, or NetworkManager's own (100 for Ethernet,
600 for Wi-Fi).

## Why it matters on a robot
Which gateway wins depends on which interface comes up first. On some boots all traffic goes to the network of the
lidar, which leads nowhere: no time, no fleet manager, no remote access.

## Bad
```ini
# lidar.nmconnection
[ipv4]
method=manual
address1=192.168.10.1/24,192.168.10.254
# uplink.nmconnection
[ipv4]
method=manual
address1=10.0.0.7/24,10.0.0.1
```

## Good
```ini
# lidar.nmconnection
[ipv4]
method=manual
address1=192.168.10.1/24
never-default=true
```

## When to ignore it
If only one of the two interfaces is ever connected.

## References
- nm-settings(5), "never-default", "route-metric"
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import note
from bringup_lint.api import rule


@rule("warning", silent="NetworkManager activates both; the kernel chooses one of the routes without a message")
def default_route_conflict(robot: Robot) -> Iterator[Finding]:
    for one, other in robot.networkmanager.pairs:
        first, second = one.default_gateway, other.default_gateway
        if first is None or second is None or not other.source.judged:
            continue
        if one.metric is None or one.metric != other.metric:
            continue
        yield finding(
            second,
            f"{one.name} and {other.name} both make a default route with metric {one.metric}: the interface that comes "
            "up first wins",
            advice="write never-default=true, or route-metric, into the profile without the uplink",
            related=[note(first, f"the default route of {one.name}")],
        )
