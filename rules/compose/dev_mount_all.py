"""A container sees every device of the host.

## What it finds
`/dev` as a volume or device together with `privileged: true`, or without `device_cgroup_rules`. With rules for the
required major numbers, mounting `/dev` is the right way to survive a replug, and is not reported.

## Why it matters on a robot
A privileged node can write to the disks and the watchdog. Without privileges and rules the device nodes are
visible, but opening them fails with EPERM.

## Bad
```yaml
volumes: [/dev:/dev]
privileged: true
```

## Good
```yaml
volumes: [/dev:/dev]
device_cgroup_rules: ["c 188:* rmw", "c 166:* rmw"]
```

## When to ignore it
When a service for maintenance, which does not run in operation, must see every device.

## References
- Docker documentation, device cgroup rules
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import rule


@rule("warning", tags=["CWE-250"])
def dev_mount_all(robot: Robot) -> Iterator[Finding]:
    for service in robot.compose.whole_services:
        mounts = [volume.where for volume in service.volumes if volume.source == "/dev"]
        mounts += [device.where for device in service.devices if device.host == "/dev"]
        if mounts and (service.is_privileged or not service.items("device_cgroup_rules")):
            limits = "and is privileged" if service.is_privileged else "and no device_cgroup_rules limit it"
            yield finding(
                mounts[0],
                f"Service '{service.name}' gets the whole /dev of the host, {limits}",
                advice='remove privileged; add device_cgroup_rules for the devices it needs: "c 188:* rmw" for ttyUSB',
            )
