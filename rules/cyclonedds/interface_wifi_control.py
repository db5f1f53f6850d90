"""DDS uses a Wi-Fi interface.

## What it finds
Cyclone DDS names an interface that the robot's netplan configures below `wifis:`. The finding is information,
because a robot without a cable has no other choice.

## Why it matters on a robot
On Wi-Fi, multicast is slow and unacknowledged. Roaming or a busy channel delays velocity commands by seconds,
or loses them.

## Bad
```xml
<NetworkInterface name="wlan0"/>
```

## Good
```xml
<NetworkInterface name="lan0"/>
```

## When to ignore it
If the robot's own nodes use the loopback interface or shared memory, and only telemetry goes over Wi-Fi.

## References
- IEEE 802.11-2020, group addressed frames are sent at a basic rate without acknowledgement
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import note
from bringup_lint.api import rule
from bringup_lint.api.dds import interface_of_device
from bringup_lint.api.dds import named_interfaces


@rule("info", silent="lost packets on Wi-Fi are sent again without a message")
def interface_wifi_control(robot: Robot) -> Iterator[Finding]:
    for configuration, domain in robot.dds.domains:
        plan = robot.dds.plan_of(configuration)
        if plan is None:
            continue
        for setting in named_interfaces(domain):
            interface = interface_of_device(plan, str(setting.effective))
            if interface is not None and interface.is_wifi:
                yield finding(
                    setting.value,
                    "All DDS traffic uses Wi-Fi: velocity commands can arrive late or not at all",
                    advice="use a wired interface for control, and bridge only what must leave the robot to Wi-Fi",
                    related=[note(interface.name, "a Wi-Fi interface")],
                )
