"""DDS needs an interface that the robot can do without.

## What it finds
A Cyclone DDS configuration that names a Wi-Fi interface (`wlan0`, `wlp1s0`) or a network adapter on USB (`usb0`,
`enx...`) beside others, without `presence_required=`. Not reported where interface-not-waited-for reports it.

## Why it matters on a robot
Cyclone DDS takes an interface that is down, or has no address yet, for absent, and every listed interface is required
by default. Out of the range of the Wi-Fi, or before it has connected at boot, no participant can be created and no
node starts, although the others would do.

## Bad
```xml
<NetworkInterface name="eth0"/>
<NetworkInterface name="wlan0"/>
```

## Good
```xml
<NetworkInterface name="eth0"/>
<NetworkInterface name="wlan0" presence_required="false"/>
```

## When to ignore it
When the robot must not run without this interface.

## References
- https://cyclonedds.io/docs/cyclonedds/latest/config/config_file_reference.html, NetworkInterface
- Cyclone DDS, `ddsi_gather_network_interfaces`
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import note
from bringup_lint.api import regex
from bringup_lint.api import rule
from bringup_lint.api.cyclonedds import Configuration
from bringup_lint.api.cyclonedds import Setting
from bringup_lint.api.dds import interface_of_device
from bringup_lint.api.dds import named_interfaces

REMOVABLE = regex(r"(?:wl(?:an|p|x|o)?|usb|enx)[0-9a-f]\w*$")


@rule("warning", symptoms=["does not match an available interface"])
def interface_required(robot: Robot) -> Iterator[Finding]:
    for configuration, domain in robot.dds.domains:
        names = list(named_interfaces(domain))
        required = [
            each for each in names if _is_removable(each) and domain.of(each.owner, "presence_required") is None
        ]
        lasting = [each for each in names if not _is_removable(each)]
        if not required or not lasting or _is_said(robot, configuration, required[0]):
            continue
        first, *others = required
        name = str(first.effective)
        yield finding(
            first.value,
            f"Without {name}, or before it has an address, no node starts: each listed interface is required",
            advice='add presence_required="false"',
            related=[
                *(note(each.value, f"nor without {each.effective}") for each in others),
                note(lasting[0].value, "this one would do"),
            ],
            chain=robot.provenance.chain_to(first.value, f"DDS needs {name}"),
        )


def _is_removable(setting: Setting) -> bool:
    return REMOVABLE.match(str(setting.effective)) is not None


def _is_said(robot: Robot, configuration: Configuration, setting: Setting) -> bool:
    """Whether netplan does not wait for the interface, which is a finding of its own."""
    plan = robot.dds.plan_of(configuration)
    interface = interface_of_device(plan, str(setting.effective)) if plan is not None else None
    return interface is not None and interface.optional is not None and bool(interface.optional.value)
