"""The sandbox cuts off DDS from the network.

## What it finds
One of these settings on a service that uses DDS:

- PrivateNetwork=yes without JoinsNamespaceOf=;
- IPAddressDeny=any without IPAddressAllow=;
- RestrictAddressFamilies= without AF_NETLINK, with which DDS lists the interfaces;
- RestrictAddressFamilies= without AF_INET and AF_INET6.

Services that are limited to the local machine need only AF_NETLINK.

## Why it matters on a robot
DDS finds no interface and cannot create the participant, or the participant starts and never sees another
node.

## Bad
```ini
[Service]
ExecStart=/bin/bash -c 'source /opt/ros/jazzy/setup.bash && exec ros2 launch rover base.launch.py'
RestrictAddressFamilies=AF_INET AF_UNIX
```

## Good
```ini
[Service]
ExecStart=/bin/bash -c 'source /opt/ros/jazzy/setup.bash && exec ros2 launch rover base.launch.py'
RestrictAddressFamilies=AF_INET AF_INET6 AF_UNIX AF_NETLINK
```

## When to ignore it
When the nodes of this service communicate only within the service.

## References
- systemd.exec(5), PrivateNetwork= and RestrictAddressFamilies=; systemd.resource-control(5), IPAddressDeny=
- getifaddrs(3) asks the kernel through AF_NETLINK
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Located
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import rule


@rule("error", symptoms=["failed to find interfaces", "Address family not supported by protocol"])
def private_network(robot: Robot) -> Iterator[Finding]:
    for unit in robot.units.dds:
        if robot.units.supervision(unit).in_container or unit.unsure_of("RestrictAddressFamilies", "IPAddressAllow"):
            continue
        local = robot.units.stays_local(unit)
        private = unit.flag("PrivateNetwork")
        if private and not local and not unit.has("JoinsNamespaceOf"):
            yield finding(
                private.where,
                f"PrivateNetwork= gives {unit.name} only a loopback interface of its own: no other node ever sees it",
                advice="remove the line",
            )
        for word in unit.words("IPAddressDeny"):
            if word == "any" and not local and not unit.has("IPAddressAllow"):
                yield finding(
                    word,
                    f"IPAddressDeny=any drops every packet of {unit.name}, DDS discovery included",
                    advice="allow the robot's networks with IPAddressAllow=",
                )
        values = unit.values("RestrictAddressFamilies")
        families = _allowed(values)
        missing = [] if families is None else _missing(families, local)
        if missing:
            yield finding(
                values[-1],
                f"Without {' and '.join(missing)} DDS cannot "
                f"{'list the interfaces' if 'AF_NETLINK' in missing else 'open its sockets'}: "
                f"the participants of {unit.name} fail",
                advice="set RestrictAddressFamilies=AF_INET AF_INET6 AF_UNIX AF_NETLINK",
            )


def _allowed(values: list[Located]) -> set[str] | None:
    """The allowed families; None if the setting only denies some, or is not set."""
    allowed: set[str] = set()
    refused = False
    for value in values:
        if value.startswith("~"):
            refused = refused or not allowed
            allowed -= set(value[1:].split())
        else:
            allowed |= set(value.split())
    return None if refused or not values else allowed - {"none"}


def _missing(families: set[str], local: bool) -> list[str]:
    if not families & {"AF_INET", "AF_INET6"} and not local:
        return ["AF_INET"]
    return [] if "AF_NETLINK" in families else ["AF_NETLINK"]
