"""A container sees every device of the host.

## What it finds
`/dev` in `devices:`, which allows every device, and `/dev` as a volume without `device_cgroup_rules` or `devices:`,
which allows none. With rules for the required major numbers, mounting `/dev` is the right way to survive a replug,
and is not reported. In a privileged service, `compose/privileged` reports it.

## Why it matters on a robot
With every device, a node can write to the disks and the watchdog. With the volume alone the device nodes are visible,
but opening them fails with EPERM.

## Bad
```yaml
volumes: [/dev:/dev]
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

ADVICE = 'add device_cgroup_rules for the devices that it needs: "c 188:* rmw" for ttyUSB'


@rule("warning", tags=["CWE-250"], symptoms=["Operation not permitted: '/dev/"])
def dev_mount_all(robot: Robot) -> Iterator[Finding]:
    for service in robot.compose.whole_services:
        if service.is_privileged or service.items("device_cgroup_rules"):
            continue
        whole = [device.where for device in service.devices if device.host == "/dev"]
        mounts = [volume.where for volume in service.volumes if volume.source == "/dev" and volume.target == "/dev"]
        if whole:
            yield finding(whole[0], f"Service '{service.name}' may use every device of the host", advice=ADVICE)
        elif mounts and not service.devices:
            message = f"Service '{service.name}' sees the devices of the host, but nothing allows it to open them"
            yield finding(mounts[0], message, advice=ADVICE)
