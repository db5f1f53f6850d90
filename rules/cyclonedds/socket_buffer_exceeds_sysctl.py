"""Cyclone DDS requires a larger socket buffer than the kernel grants.

## What it finds
`SocketReceiveBufferSize min` or `SocketSendBufferSize min` (or their older names) above twice
`net.core.rmem_max` or `wmem_max`: the kernel doubles the requested size and limits it there. `max` alone is
only a request and is not reported.
- **error**: a sysctl file sets the limit, or the tree is a complete root file system.
- **warning**: no file of the tree sets the limit, so the kernel's default of 212992 is assumed. So it is where scripts
  that no other file or page names, and that start nothing themselves, only set it with `sysctl -w`, until the next
  boot. It is information where another script, an image, a playbook or a unit of the tree names the limit.

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

from __future__ import annotations

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import NamedTuple
from bringup_lint.api import Related
from bringup_lint.api import Robot
from bringup_lint.api import Source
from bringup_lint.api import finding
from bringup_lint.api import note
from bringup_lint.api import regex
from bringup_lint.api import rule
from bringup_lint.api.cyclonedds import Configuration
from bringup_lint.api.cyclonedds import least_buffers
from bringup_lint.api.cyclonedds import size_of
from bringup_lint.api.host import KernelParameter

WRITING = ("shell-script", "dockerfile", "compose", "ansible", "cloud-init", "systemd-unit")
"""Kinds of files that may raise a limit, or have it raised."""
KEPT = regex(r"sysctl\.(?:conf|d)\b|sysctl[ \t]+(?:-p|--system|--load)", hints="sysctl")
"""A script that has a limit set at each boot."""
STARTS = regex(r"\bros2\b|\b(?:docker|podman|exec|eval|source)\b|launch|\.(?:ba)?sh\b|\$@|\$\*")
"""A script that may start the nodes, or something that does."""


class Raised(NamedTuple):
    """What of the tree may raise a limit beside the files of sysctl."""

    by: list[Source]
    is_kept: bool
    """Not only until the next boot, or something starts it at each."""


UNRAISED = Raised([], False)


@rule(
    "error",
    symptoms=["failed to increase socket receive buffer size", "failed to increase socket send buffer size"],
)
def socket_buffer_exceeds_sysctl(robot: Robot) -> Iterator[Finding]:
    raised: dict[str, Raised] = {}
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
            scripted = UNRAISED if known else _in_script(robot, limit_name, raised)
            has = f"this robot has {granted}" if known else f"no file of this tree raises it from {granted}"
            if scripted.by:
                has = f"only a script of this tree raises it from {granted}"
            yield finding(
                setting.value,
                f"At least {setting.value} needs {limit_name} >= {(wanted + 1) // 2}, but {has}: no node starts"
                + _until(scripted),
                advice=f"set {limit_name} = {wanted} in /etc/sysctl.d, or use max instead of min",
                related=[*_limit(limit), *_readers(robot, configuration)],
                chain=robot.provenance.chain_to(setting.value, f"DDS requires at least {setting.value}"),
                severity=None if known else "info" if scripted.by and scripted.is_kept else "warning",
                confidence="high" if known else "medium",
            )


def _until(raised: Raised) -> str:
    if not raised.by:
        return ""
    name = raised.by[0].basename
    return " until it ran" if raised.is_kept else f" until somebody has run {name}, after each boot again"


def _in_script(robot: Robot, name: str, found: dict[str, Raised]) -> Raised:
    """What may raise a limit; what was found out is kept."""
    if name not in found:
        found[name] = _raised(robot, name)
    return found[name]


def _raised(robot: Robot, name: str) -> Raised:
    spelt = (name, name.replace(".", "/"))
    by = [source for source in robot.of_kind(*WRITING) if any(each in source.said for each in spelt)]
    set_by = {source for source, run in robot.scripts.run("sysctl") if any(name in word for word in run.arguments)}
    return Raised(by, not all(each in set_by and _is_lost(robot, each) for each in by))


def _is_lost(robot: Robot, source: Source) -> bool:
    """Whether a script changes the running kernel alone, and people start it by itself."""
    if KEPT.search(source.said) or STARTS.search(source.said):
        return False
    return not robot.scripts.starts_by_itself(source) and not robot.scripts.is_named(source)


def _limit(limit: KernelParameter | None) -> list[Related]:
    return [note(limit.value, "the limit")] if limit else []


def _readers(robot: Robot, configuration: Configuration) -> list[Related]:
    return [
        note(reader.uri, f"{reader.process.name} reads the file") for reader in robot.dds.readers(configuration)[:3]
    ]
