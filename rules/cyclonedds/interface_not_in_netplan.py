"""Cyclone DDS uses an interface that the robot does not have.

## What it finds
An interface name that no file of the robot's netplan defines. Files are compared only if they are below the
same root and the tree has exactly one netplan configuration. Not reported are:
- names that a `match:` may give
- names of containers, tunnels or USB gadgets
- names of NetworkManager's profiles, and names that a .link or .netdev file, a udev rule or `ip link add` gives
- `presence_required="false"`, if other interfaces are listed too

Names that a network card gets by default (`enp3s0`, `wlan0`, `eth0`) are a warning if netplan configures a physical
interface. If a netplan file is outside of `/etc/netplan`, for example where a script copies it from, others may be on
the robot: the finding is an info.

## Why it matters on a robot
The library reports `eth0: does not match an available interface` and creates no participant: no ROS node
starts. This happens as soon as a network card is renamed or replaced.

## Bad
```xml
# netplan: lan0 only
<NetworkInterface name="eth0"/>
```

## Good
```xml
<NetworkInterface name="lan0"/>
```

## When to ignore it
If something other than netplan creates the interface on the robot, such as a VPN client or a driver.

## References
- Cyclone DDS 0.10.5 and 11.0.1, tested with the real library
- https://github.com/tier4/edge-auto-jetson/pull/82
"""

import re
from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import note
from bringup_lint.api import rule
from bringup_lint.api.dds import interface_of_device
from bringup_lint.api.dds import may_exist
from bringup_lint.api.dds import named_interfaces


@rule("error", symptoms=["does not match an available interface"])
def interface_not_in_netplan(robot: Robot) -> Iterator[Finding]:
    for configuration, domain in robot.dds.domains:
        plan = robot.dds.plan_of(configuration)
        if plan is None:
            continue
        names = list(named_interfaces(domain))
        for setting in names:
            name = str(setting.effective)
            required = domain.of(setting.owner, "presence_required")
            optional = required is not None and (required.effective or "false").lower() == "false" and len(names) > 1
            if not any(plan.devices) or optional or interface_of_device(plan, name) or may_exist(plan, name):
                continue
            if robot.networkmanager.configures(name) or _is_named_elsewhere(robot, name):
                continue
            known = [interface for interface in plan.interfaces.values() if interface.device]
            predictable = name.startswith(("en", "wl", "eth0")) and any(each.is_physical for each in known)
            whole = all("/etc/netplan/" in f"/{each.name.span.source.name}" for each in known)
            yield finding(
                setting.value,
                f"Interface {name} is not configured on this robot: 'does not match an available "
                "interface', no node starts",
                advice=f"use one of {', '.join(str(each.device) for each in known)}",
                chain=robot.provenance.chain_to(setting.value, f"DDS uses {name}"),
                related=[note(each.name, "netplan configures this one") for each in known[:3]],
                severity="info" if not whole else "warning" if predictable else None,
            )


def _is_named_elsewhere(robot: Robot, name: str) -> bool:
    """Whether a .link or .netdev file, a udev rule or a command gives an interface this name."""
    written = re.escape(name)
    given = rf"\bNAME\s*:?=\s*\"?{written}\b|^Name={written}\s*$"
    return robot.mentions(re.compile(rf"{given}|\blink\s+add\b[^\n]{{0,200}}\b{written}\b", re.M))
