"""A unit may start before its CAN interface exists.

## What it finds
A service that names a `canN` on its command line or in its environment without waiting for it. It needs `After=` or
`BindsTo=` on the device unit `sys-subsystem-net-devices-canN.device`, on the networkd-wait-online instance of that
interface, or on a unit of the tree that sets the interface up. A unit that sets up the interface itself
is reported when a target starts it at boot and it waits for no device, no other service and in no loop, and is not
started again.

## Why it matters on a robot
USB adapters and MCP2515 boards appear seconds after the boot begins to start services. The driver fails with `No
such device`, and with two adapters it may open the wrong one.

## Bad
```ini
[Service]
ExecStart=/opt/robot/drive --can can0
```

## Good
```ini
[Unit]
BindsTo=sys-subsystem-net-devices-can0.device
After=sys-subsystem-net-devices-can0.device
```

## When to ignore it
When the driver itself waits for the interface and opens it again after an error.

## References
- systemd.device(5)
- https://github.com/systemd/systemd/issues/20651
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import note
from bringup_lint.api import rule


@rule(
    "warning",
    symptoms=[
        "No such device",
        "SIOCGIFINDEX: No such device",
        "ERROR while getting interface flags: No such device",
        "Could not access SocketCAN device",
    ],
)
def unit_order(robot: Robot) -> Iterator[Finding]:
    for unit, name, place in robot.can.users:
        after = [*unit.words("After"), *unit.words("BindsTo"), *unit.words("Requires")]
        if any(name in word for word in after) or robot.can.sets_up(unit, name, after):
            continue
        device = f"sys-subsystem-net-devices-{name}.device"
        yield finding(
            place,
            f"{unit.name} may start before {name} exists",
            advice=f"add BindsTo={device} and After={device}",
        )
    for unit, name, place in robot.can.early_setups:
        device = f"sys-subsystem-net-devices-{name}.device"
        yield finding(
            place,
            f"{unit.name} sets up {name} at boot: if it does not exist yet, it stays down",
            advice=f"add BindsTo={device} and After={device}, or let systemd-networkd configure {name}",
            confidence="medium",
            related=[note(word, f"does not wait for {name}") for word in unit.words("After")[:1]],
        )
