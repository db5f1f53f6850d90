"""Cyclone DDS requires a larger socket buffer than the kernel grants.

## What it finds
`SocketReceiveBufferSize min` or `SocketSendBufferSize min` (or their older names) above twice
`net.core.rmem_max` or `wmem_max`: the kernel doubles the requested size and limits it there. `max` alone is
only a request and is not reported.
- **error**: a sysctl file sets the limit, or the tree is a complete root file system.
- **warning**: no file of the tree sets the limit, so the kernel's default of 212992 is assumed. It is information
  where a script, an image, a playbook or a unit of the tree names the limit.

## Why it matters on a robot
The library reports `failed to increase socket receive buffer size` and creates no participant: no ROS node
starts. Privileges do not help, and in a container the limit of the host applies.

## Bad
```xml
# net.core.rmem_max is 212992
<SocketReceiveBufferSize min="10MB"/>
```

## Good
```xml
# sysctl.d: net.core.rmem_max = 10485760
<SocketReceiveBufferSize min="10MB"/>
```

## When to ignore it
If the limit is raised on the robot outside the tree, for example by the host of a container or a provisioning
script.

## References
- Cyclone DDS 0.10.5 and 11.0.1, tested with the real library: 8192 kB passes and 8193 kB fails with rmem_max
  4194304
- https://github.com/eclipse-cyclonedds/cyclonedds/pull/1001
- socket(7), SO_RCVBUF
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Related
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import note
from bringup_lint.api import rule
from bringup_lint.api.cyclonedds import Configuration
from bringup_lint.api.cyclonedds import least_buffers
from bringup_lint.api.cyclonedds import size_of
from bringup_lint.api.host import KernelParameter

WRITING = ("shell-script", "dockerfile", "compose", "ansible", "cloud-init", "systemd-unit")
"""Kinds of files that may raise a limit, or have it raised."""


@rule(
    "error",
    symptoms=["failed to increase socket receive buffer size", "failed to increase socket send buffer size"],
)
def socket_buffer_exceeds_sysctl(robot: Robot) -> Iterator[Finding]:
    raised: dict[str, bool] = {}
    used = ((each, domain) for each, domain in robot.dds.domains if robot.dds.in_use(each))
    for configuration, domain in used:
        for setting, limit_name in least_buffers(domain):
            wanted = size_of(setting)
            limit = robot.sysctl.get(limit_name)
            if wanted is None or not robot.sysctl.certain or (limit is not None and not limit.value.isdecimal()):
                continue
            granted = int(limit.value) if limit else 212992
            if wanted <= 2 * granted or (limit is not None and not robot.same_robot(limit.value, configuration.source)):
                continue
            known = limit is not None or robot.tree.complete
            scripted = not known and _in_script(robot, limit_name, raised)
            has = f"this robot has {granted}" if known else f"no file of this tree raises it from {granted}"
            if scripted:
                has = f"only a script of this tree raises it from {granted}"
            yield finding(
                setting.value,
                f"At least {setting.value} needs {limit_name} >= {(wanted + 1) // 2}, but {has}: no node starts"
                + (" until it ran" if scripted else ""),
                advice=f"set {limit_name} = {wanted} in /etc/sysctl.d, or use max instead of min",
                related=[*_limit(limit), *_readers(robot, configuration)],
                chain=robot.provenance.chain_to(setting.value, f"DDS requires at least {setting.value}"),
                severity=None if known else "info" if scripted else "warning",
                confidence="high" if known else "medium",
            )


def _in_script(robot: Robot, name: str, found: dict[str, bool]) -> bool:
    """Whether a script or an image may raise a limit; what was found out is kept."""
    if name not in found:
        found[name] = _is_raised(robot, name)
    return found[name]


def _is_raised(robot: Robot, name: str) -> bool:
    spelt = (name, name.replace(".", "/"))
    return any(each in source.said for source in robot.of_kind(*WRITING) for each in spelt)


def _limit(limit: KernelParameter | None) -> list[Related]:
    return [note(limit.value, "the limit")] if limit else []


def _readers(robot: Robot, configuration: Configuration) -> list[Related]:
    return [
        note(reader.uri, f"{reader.process.name} reads the file") for reader in robot.dds.readers(configuration)[:3]
    ]
