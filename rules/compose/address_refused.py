"""Docker does not give a container its fixed address.

## What it finds
An `ipv4_address` or `ipv6_address` of a service that
- lies in none of the subnets that `ipam:` gives to the network, in the file or in one that includes it,
- is the gateway of the network,
- another service of the file has in the same network, where neither has `profiles`,
- belongs to a network for which `ipam:` gives no subnet.

Silent for external networks, for addresses and subnets from variables, and for networks with another driver than
`bridge` that has no subnet.

## Why it matters on a robot
`docker compose up` creates the container and does not start it. What runs beside it waits for a service that never
comes.

## Bad
```yaml
services:
  base:
    networks:
      robot:
        ipv4_address: 172.30.1.10
networks:
  robot:
    ipam:
      config: [{subnet: 172.30.0.0/24}]
```

## Good
```yaml
services:
  base:
    networks:
      robot:
        ipv4_address: 172.30.0.10
networks:
  robot:
    ipam:
      config: [{subnet: 172.30.0.0/24}]
```

## When to ignore it
When the file is always loaded together with one that changes the network.

## References
- https://docs.docker.com/reference/compose-file/services/#ipv4_address-ipv6_address
- https://docs.docker.com/reference/compose-file/networks/#ipam
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import note
from bringup_lint.api import regex
from bringup_lint.api import rule
from bringup_lint.api.compose import refused_addresses

FIXED = regex(r"\bipv[46]_address\b", hints="ipv4_address ipv6_address")
TEXTS = {
    "outside": (
        "{address} is in no subnet of the network '{network}'",
        "take an address of the subnet",
        "the subnet",
    ),
    "gateway": ("{address} is the gateway of the network '{network}'", "take another address", "the gateway"),
    "taken": ("Another service has {address} in the network '{network}', too", "take another address", "has it, too"),
    "no subnet": (
        "The network '{network}' has no subnet that is configured",
        "write ipam: with the subnet of the address",
        "defined here",
    ),
}


@rule(
    "error",
    symptoms=[
        "no configured subnet contains IP address *",
        "It does not belong to any of this network's subnets",
        "user specified IP address is supported only when connecting to networks with user configured subnets",
        "failed to set up container networking: Address already in use",
    ],
)
def address_refused(robot: Robot) -> Iterator[Finding]:
    if not robot.mentions(FIXED):
        return
    for refused in refused_addresses(robot.compose):
        message, advice, other = TEXTS[refused.why]
        yield finding(
            refused.address,
            message.format(address=refused.address, network=refused.network)
            + f": docker does not start '{refused.service.name}'",
            advice=advice,
            related=[note(refused.other, other)],
        )
