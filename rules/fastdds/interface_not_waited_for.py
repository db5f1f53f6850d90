"""The DDS address may not exist yet when ROS starts.

## What it finds
An `interfaceWhiteList` address of an interface that the robot's netplan marks `optional: true`, so the boot
does not wait for it. No unit that reads the profile waits for the interface itself. A list with another
address outside the loopback network is not reported.

## Why it matters on a robot
The interface has no address yet when the nodes start: the library filters out the whole list, and the readers
fail. Started by hand minutes later, everything works.

## Bad
```xml
<!-- netplan: eth1: {optional: true, addresses: [192.168.20.5/24]} -->
<interfaceWhiteList>
  <address>192.168.20.5</address>
</interfaceWhiteList>
```

## Good
```xml
<!-- netplan: eth1: {addresses: [192.168.20.5/24]} -->
<interfaceWhiteList>
  <address>192.168.20.5</address>
</interfaceWhiteList>
```

## When to ignore it
If the service restarts until the interface has its address and that delay is acceptable.

## References
- Fast DDS documentation, "Interface whitelist"
- netplan YAML reference, "optional"
- https://github.com/eProsima/Fast-DDS/issues/1880
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import note
from bringup_lint.api import rule
from bringup_lint.api.dds import interface_with
from bringup_lint.api.fastdds import whitelisted_addresses


@rule("error", confidence="medium", symptoms=["All whitelist interfaces were filtered out"])
def interface_not_waited_for(robot: Robot) -> Iterator[Finding]:
    for profiles in robot.dds.profile_files:
        plan = robot.dds.plan_of(profiles)
        if plan is None:
            continue
        for element in profiles.document.elements:
            listed = whitelisted_addresses(element)
            outside = [(text, address) for text, address in listed if not address.is_loopback]
            if len(outside) != 1:
                continue
            text, address = outside[0]
            interface = interface_with(plan, address)
            if interface is None or interface.optional is None or not interface.optional.value:
                continue
            if interface.device is None or robot.dds.waits_for(profiles, str(interface.device)):
                continue
            yield finding(
                text,
                f"The boot does not wait for {interface.device} ({address}): if ROS starts first, readers fail",
                advice="delete optional, and start ROS after network-online.target",
                chain=robot.provenance.chain_to(text, f"DDS uses only {address}"),
                related=[note(interface.optional.where, "netplan does not wait for it")],
            )
