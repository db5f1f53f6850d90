"""Fast DDS requests a larger socket buffer than the kernel grants.

## What it finds
`sendSocketBufferSize`, `listenSocketBufferSize`, `sendBufferSize` or `receiveBufferSize` above the value of
`net.core.wmem_max` or `rmem_max` in the tree's sysctl files.

## Why it matters on a robot
The library lowers the value, and logs it only at the level Warning, which is off by default: large messages such as
point clouds are still dropped.

## Bad
```xml
# net.core.rmem_max = 4194304
<listenSocketBufferSize>10485760</listenSocketBufferSize>
```

## Good
```xml
# net.core.rmem_max = 10485760
<listenSocketBufferSize>10485760</listenSocketBufferSize>
```

## When to ignore it
If a provisioning script outside the tree raises the limit on the robot.

## References
- Fast DDS 2.14.5, tested with the real library: 100 MB accepted with a limit of 4 MiB
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
        "UDPTransport receiveBufferSize could not be set to the desired value. Using * instead of *",
        "UDPTransport sendBufferSize could not be set to the desired value. Using * instead of *",
    ],
)
def socket_buffer_exceeds_sysctl(robot: Robot) -> Iterator[Finding]:
    limits = {
        "sendSocketBufferSize": "net.core.wmem_max",
        "sendBufferSize": "net.core.wmem_max",
        "listenSocketBufferSize": "net.core.rmem_max",
        "receiveBufferSize": "net.core.rmem_max",
    }
    for profiles in robot.dds.profile_files:
        if not robot.dds.in_use(profiles):
            continue
        for element in profiles.document.elements:
            name = limits.get(str(element.name))
            parameter = robot.sysctl.get(name) if name else None
            limit = robot.sysctl.number(name) if name and robot.sysctl.certain else None
            if parameter is None or limit is None:
                continue
            if element.text.isdecimal() and int(element.text[:12]) > limit:
                yield finding(
                    element.text,
                    f"The kernel grants {limit} bytes ({name}), not {element.text}: large messages are still dropped",
                    advice=f"set {name} = {element.text} in /etc/sysctl.d",
                    related=[note(parameter.value, "the limit")],
                    chain=robot.provenance.chain_to(element.text, f"DDS requests {element.text} bytes"),
                )
