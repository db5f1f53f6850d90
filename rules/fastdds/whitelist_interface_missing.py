"""The robot does not have a whitelisted Fast DDS address.

## What it finds
An `interfaceWhiteList` address that no interface of the robot's netplan has. Files are compared only below
the same root, and only if no interface gets its address by DHCP.

And the name of an interface in the place of an address, in a transport of the default participant, on a robot with
ROS 2 up to Iron: Fast DDS takes names since 2.14.

## Why it matters on a robot
The library filters out all whitelisted interfaces: it creates the node, but the readers of the node fail.

## Bad
```xml
<interfaceWhiteList>
  <address>10.0.0.99</address>
</interfaceWhiteList>
```

## Good
```xml
<interfaceWhiteList>
  <address>10.0.0.10</address>
</interfaceWhiteList>
```

## When to ignore it
If something other than netplan assigns the address on the robot, such as a VPN client or a script.

## References
- Fast DDS 2.14.5, tested with the real library
- https://github.com/eProsima/Fast-DDS/pull/3988, which adds names
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import note
from bringup_lint.api import regex
from bringup_lint.api import rule
from bringup_lint.api.addresses import address_of
from bringup_lint.api.fastdds import used_transports
from bringup_lint.api.ros import at_least
from bringup_lint.api.xml import Element

NAME = regex(r"(?:e(?:th|n)|wl|br|can|wg|tun|usb|docker)[\w.-]*")


@rule("error", symptoms=["All whitelist interfaces were filtered out"])
def whitelist_interface_missing(robot: Robot) -> Iterator[Finding]:
    takes_names = at_least(robot.target.ros, "jazzy") is not False
    for profiles in robot.dds.profile_files:
        own = robot.dds.own_addresses(profiles)
        used = used_transports(profiles)
        for element in profiles.document.elements:
            if element.name != "address" or element.parent is None or element.parent.name != "interfaceWhiteList":
                continue
            if not takes_names and NAME.fullmatch(element.text) and is_used(element, used):
                yield finding(
                    element.text,
                    f"Fast DDS of {robot.target.ros} compares addresses only: {element.text} is filtered out",
                    advice="write the address of the interface",
                )
            if not own:
                continue
            address = address_of(element.text)
            if address is not None and not address.is_loopback and str(address) not in own:
                yield finding(
                    element.text,
                    f"No interface of this robot has {address}: it is filtered out, and readers fail",
                    advice=f"use one of {', '.join(sorted(own))}",
                    chain=robot.provenance.chain_to(element.text, f"DDS uses only {address}"),
                    related=[note(each, "the robot's own address") for each in robot.dds.own_places(profiles)[:3]],
                )


def is_used(address: Element, used: set[str]) -> bool:
    """Whether a participant names the transport that an address of a white list is in."""
    descriptor = address.parent.parent if address.parent is not None else None
    identifier = descriptor.find("transport_id") if descriptor is not None else None
    return identifier is not None and str(identifier.text) in used
