"""A node in a container opens a device that the container does not have.

## What it finds
A path below /dev in the parameters of a node that a service starts with `ros2 launch`, in any case, where neither
`devices:` nor a volume has it:
- the name of a link (that of a udev rule of the tree, or `/dev/serial/by-id/...`), also in a privileged container:
  Docker gives it the device nodes of the host, and no links;
- a serial port, in a container that is not privileged.

Silent for services of which several compose files speak, with paths from variables, and where an argument may replace
the parameter.

## Why it matters on a robot
On the host the driver works, and in the container it ends with "No such file or directory" at each start.

## Bad
```yaml
privileged: true
command: ros2 launch heron_lidar lidar.launch.py   # its parameters say /dev/lidar
```

## Good
```yaml
privileged: true
volumes: ["/dev:/dev"]
command: ros2 launch heron_lidar lidar.launch.py
```

## When to ignore it
When udev runs in the container.

## References
- https://docs.docker.com/reference/compose-file/services/#devices
- https://docs.docker.com/engine/containers/run/#runtime-privilege-and-linux-capabilities
- moby, oci/devices_linux.go and opencontainers/runc, libcontainer/devices: links are passed over
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import note
from bringup_lint.api import rule
from bringup_lint.api.host import ungiven_devices


@rule(
    "error",
    confidence="medium",
    silent="the driver reports a port that does not exist, as for every other reason",
)
def device_missing(robot: Robot) -> Iterator[Finding]:
    if not robot.compose.files or not robot.has_launch_files:
        return
    for each in ungiven_devices(robot.files, robot.runners.all, robot.compose, robot.udev, robot.launch, robot.params):
        service = each.service
        privileged = service.is_privileged
        why = (
            "a privileged container gets devices, and not the links to them" if privileged else "nothing hands it over"
        )
        yield finding(
            service.name,
            f"'{service.name}' has no {each.path}: {why}",
            advice="mount /dev:/dev, too" if privileged else f"add {each.path} to devices:",
            related=[
                note(each.path, "opened here"),
                *([note(each.link, "this link")] if each.link is not None else []),
            ],
        )
