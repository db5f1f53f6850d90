"""The user of a container may not open its device.

## What it finds
A service with a serial port, a camera, a sound card, an input device, or an I2C, SPI or GPIO device below `devices:`,
that runs as a user other than root without the group of that device: `group_add:` does not have it, and the Dockerfile
of the tree does not make the user a member. With a group in `user:`, as in `1000:1000`, Docker gives the process that
group alone, whatever the image says.

Silent for privileged services, for users that a variable names, and in trees with a udev rule that gives devices to
everybody, to a user or to a group of the robot's own, or with a command that does.

## Why it matters on a robot
`devices:` makes the node visible, with the owner and the mode that it has on the host. The driver ends with "Permission
denied", although the same command works as root.

## Bad
```yaml
user: "1000:1000"
devices: ["/dev/ttyACM0:/dev/ttyACM0"]
```

## Good
```yaml
user: "1000:1000"
group_add: [dialout]
devices: ["/dev/ttyACM0:/dev/ttyACM0"]
```

## When to ignore it
When a udev rule of the host gives the device to everybody, or to the group of that user.

## References
- https://docs.docker.com/reference/compose-file/services/#group_add
- https://docs.docker.com/reference/dockerfile/#user
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import note
from bringup_lint.api import rule
from bringup_lint.api.compose import closed_devices


@rule(
    "warning",
    confidence="medium",
    symptoms=["Permission denied: '/dev/", "could not open port /dev/*Permission denied"],
)
def device_group(robot: Robot) -> Iterator[Finding]:
    for closed in closed_devices(robot.files, robot.compose):
        yield finding(
            closed.service.place_of("devices"),
            f"'{closed.service.name}' runs as {closed.user}, without the group {closed.group}: it may not open"
            f" {closed.device.host}",
            advice=f"add group_add: [{closed.group}], by its number if the image lacks the name",
            related=[note(closed.device.where, "this device"), note(closed.user, "the user")],
        )
