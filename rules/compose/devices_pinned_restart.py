"""A device that can be replugged is pinned in devices:.

## What it finds
A USB serial device or a gamepad (`/dev/input/js0`, `/dev/input/event5`) in `devices:` of a service with a restart
policy, or a link that the container knows as one.
Not where a volume brings the folder of the device, too.
On-board UARTs (`ttyAMA`, `ttyS`, `ttyTHS`), i2c, gpio and spi cannot be unplugged and are not reported.

## Why it matters on a robot
Docker resolves the path once, when it creates the container. After a replug the container holds a dead device node.
If the device is missing at boot, the container cannot start at all: `error gathering device information`.

## Bad
```yaml
devices: [/dev/ttyUSB0:/dev/ttyUSB0]
restart: unless-stopped
```

## Good
```yaml
volumes: [/dev:/dev]
device_cgroup_rules: ["c 188:* rmw", "c 166:* rmw"]
restart: unless-stopped
```

## When to ignore it
When the device is fixed inside the robot and never loses power separately.

## References
- https://github.com/moby/moby/issues/46608, https://github.com/moby/moby/issues/35359
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import note
from bringup_lint.api import regex
from bringup_lint.api import rule
from bringup_lint.api.compose import Device

REPLUGGED = regex(r"/dev/(?:tty(?:USB|ACM)\d+|serial/by-(?:id|path)/.+|input/(?:js|event)\d+)")
INPUT = "/dev/input/"
SERIAL = regex(r"/dev/tty(?:USB|ACM)\d+")


@rule("warning", symptoms=["error gathering device information while adding custom device"])
def devices_pinned_restart(robot: Robot) -> Iterator[Finding]:
    for service in robot.compose.services:
        if not service.restarts:
            continue
        mounted = [str(each.source).rstrip("/") for each in service.volumes if each.source is not None]
        for device in service.devices:
            if any(each.startswith("/dev") and device.host.startswith(f"{each}/") for each in mounted):
                continue  # the container sees what is plugged in
            if _is_replugged(device) and device.where.span.start >= service.body.span.start:
                is_input = device.host.startswith(INPUT)
                numbers = '["c 13:* rmw"]' if is_input else '["c 188:* rmw", "c 166:* rmw"]'
                yield finding(
                    device.where,
                    f"{device.host} is resolved once: after a replug '{service.name}' has lost it",
                    advice=f"mount {INPUT if is_input else '/dev'} and add device_cgroup_rules: {numbers}",
                    related=[note(service.restart, "restarted here")] if service.restart else [],
                )


def _is_replugged(device: Device) -> bool:
    """A USB serial device by its own name, or a link that the container knows as one."""
    if REPLUGGED.fullmatch(device.host):
        return True
    return device.target is not None and bool(SERIAL.fullmatch(device.target))
