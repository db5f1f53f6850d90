"""Two interfaces claim the default route.

## What it finds
More than one static default route of the same family, table and metric over all interfaces and files that
netplan reads together. As info: a static default route beside an interface that takes another one from
DHCP.

## Why it matters on a robot
The kernel keeps one of them, and which one depends on the order in which the links come up. The robot
reaches its base station on one boot and the internet on the next. Netplan only warns.

## Bad
```yaml
eth0:  {routes: [{to: default, via: 10.0.0.1}]}
wlan0: {routes: [{to: default, via: 10.0.1.1}]}
```

## Good
```yaml
eth0:  {routes: [{to: default, via: 10.0.0.1}]}
wlan0: {routes: [{to: default, via: 10.0.1.1, metric: 600}]}
```

## References
- netplan YAML reference, "Default routes"
- robot-bringup guide, "Static IP Configuration"
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import note
from bringup_lint.api import rule


@rule(
    "warning",
    symptoms=[
        "Conflicting default route declarations for IPv4",
        "Problem encountered while validating default route consistency",
    ],
)
def default_route_conflict(robot: Robot) -> Iterator[Finding]:
    for plan in robot.netplan.plans:
        first = {}
        for interface, family, table, metric, where in plan.default_routes:
            other, place = first.setdefault((family, table, metric), (interface, where))
            if place is not where:
                both = (
                    f"{other.name} and {interface.name} both claim"
                    if other is not interface
                    else f"{other.name} claims twice"
                )
                yield finding(
                    where,
                    f"{both} the IPv{family} default route (table {table}, metric {metric or 'default'})",
                    advice="give one of them a metric, or a table of its own",
                    related=[note(place, "the other default route")],
                )
        yield from _beside_dhcp(plan)


def _beside_dhcp(plan):
    static = next((route for route in plan.default_routes if route[1] == 4 and route[2] == "main"), None)
    for interface in plan.interfaces.values():
        flag = interface.flag("dhcp4")
        if static is None or flag is None or not flag.value or interface.value("dhcp4-overrides", "route-metric"):
            continue
        use = interface.flag("dhcp4-overrides", "use-routes")
        if use is None or use.value:
            yield finding(
                flag.where,
                f"DHCP gives {interface.name} a default route beside the static one of {static[0].name}",
                advice="set dhcp4-overrides: {use-routes: false}, or a route-metric",
                related=[note(static[4], "the static default route")],
                severity="info",
            )
