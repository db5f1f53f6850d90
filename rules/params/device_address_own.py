"""A driver is told to connect to the robot itself.

## What it finds
An address of a sensor (`sensor_ip`, `lidar_ip`, `device_ip`, ..., and `ip_address` of the drivers of laser scanners) in
parameter and launch files that netplan or a profile of NetworkManager of the tree gives to the robot's own interface.

## Why it matters on a robot
Two devices of one network cannot have one address. The driver connects to the computer that it runs on, where nothing
listens on the port of the sensor: there are no scans, and the log shows a refused connection again and again.

## Bad
```yaml
urg_node:
  ros__parameters:
    ip_address: 192.168.0.15      # netplan: addresses: [192.168.0.15/24]
```

## Good
```yaml
urg_node:
  ros__parameters:
    ip_address: 192.168.0.10
```

## When to ignore it
When the network files are those of another computer, or a program on the robot stands in for the sensor.

## References
- ip(7), netplan-yaml(5), nm-settings(5)
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import note
from bringup_lint.api import rule
from bringup_lint.api.host import own_addresses


@rule("warning", symptoms=["Could not open network Hokuyo"])
def device_address_own(robot: Robot) -> Iterator[Finding]:
    for each in own_addresses(robot.params, robot.launch, robot.netplan, robot.networkmanager):
        if robot.same_robot(each.given, each.own):
            yield finding(
                each.given,
                f"{each.name} {each.given} is the address of the robot itself: the driver does not reach its device",
                advice="write the address of the device",
                related=[note(each.own, "the robot gets this address")],
            )
