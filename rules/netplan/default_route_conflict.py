"""Two interfaces have the same default route.

## What it finds
Default routes that compete, over all interfaces and files that netplan reads together:
- **warning**: more than one static default route of the same family, table and metric.
- **info**: a static default route, and another interface that gets one from DHCP without a `route-metric`.

## Why it matters on a robot
The kernel keeps one of them, and which one depends on the order in which the links come up. The robot reaches
its base station after one boot and the internet after the next. Netplan only prints a warning.

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

## When to ignore it
If only one of the two interfaces is ever connected at a time. For the DHCP case, if the DHCP server does not
announce a router.

## References
- netplan YAML reference, "Default routes"
- robot-bringup guide, "Static IP Configuration"
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Located
from bringup_lint.api import Robot
from bringup_lint.api import Span
from bringup_lint.api import finding
from bringup_lint.api import note
from bringup_lint.api import rule
from bringup_lint.api.netplan import Interface
from bringup_lint.api.netplan import Plan


@rule(
    "warning",
    symptoms=[
        "Conflicting default route declarations for IPv4",
        "Problem encountered while validating default route consistency",
    ],
)
def default_route_conflict(robot: Robot) -> Iterator[Finding]:
    for plan in robot.netplan.plans:
        first: dict[tuple[object, ...], tuple[Interface, Located | Span]] = {}
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
                    advice="give one of them a metric or its own table",
                    related=[note(place, "the other default route")],
                )
        yield from _beside_dhcp(plan)


def _beside_dhcp(plan: Plan) -> Iterator[Finding]:
    static = next((route for route in plan.default_routes if route[1] == 4 and route[2] == "main"), None)
    for interface in plan.interfaces.values():
        flag = interface.flag("dhcp4")
        if static is None or flag is None or not flag.value or interface.value("dhcp4-overrides", "route-metric"):
            continue
        use = interface.flag("dhcp4-overrides", "use-routes")
        if use is None or use.value:
            yield finding(
                flag.where,
                f"DHCP gives {interface.name} a default route in addition to the static one of {static[0].name}",
                advice="set dhcp4-overrides: {use-routes: false}, or a route-metric",
                related=[note(static[4], "the static default route")],
                severity="info",
            )
