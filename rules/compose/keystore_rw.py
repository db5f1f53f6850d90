"""A container can change the SROS2 keystore.

## What it finds
A keystore (the target of `ROS_SECURITY_KEYSTORE` or a folder above it, or a path with `keystore` in it) that is
mounted without `ro`. One keystore is one finding in a file, however many services mount it.

## Why it matters on a robot
A node only reads its enclave. With write access an intruder can replace the permissions of every other node.

## Bad
```yaml
volumes:
  - /opt/robot/keystore:/keystore
```

## Good
```yaml
volumes:
  - /opt/robot/keystore/enclaves/robot/nav:/keystore/enclaves/robot/nav:ro
```

## When to ignore it
When the service creates or renews the keys and no ROS node runs in it.

## References
- robotics-security guide, container hardening
- CWE-732
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Located
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import fix
from bringup_lint.api import note
from bringup_lint.api import rule
from bringup_lint.api.compose import Service
from bringup_lint.api.compose import Volume


@rule("warning", fix="unsafe", silent="a writable mount works", tags=["CWE-732"])
def keystore_rw(robot: Robot) -> Iterator[Finding]:
    for file in robot.compose.files:
        if file.source.template:
            continue
        keystores: dict[str, list[tuple[Service, Volume]]] = {}
        for service in file.services:
            for volume in _writable_keystores(service):
                keystores.setdefault(str(volume.source), []).append((service, volume))
        for mounts in keystores.values():
            yield _finding(mounts)


def _finding(mounts: list[tuple[Service, Volume]]) -> Finding:
    (service, first), *others = mounts
    who = f"'{service.name}'" + (f" (and {len(others)} more)" if others else "")
    short = [volume.where for _, volume in mounts if volume.where.count(":") == 1 and "$" not in volume.where]
    return finding(
        first.where,
        f"{who} can change the keystore",
        advice="mount it read-only, and only the enclave that the service needs",
        related=[note(volume.where, f"'{other.name}' can change it too") for other, volume in others],
        fix=fix("mount it read-only", *((where, f"{where}:ro") for where in short)) if short else None,
    )


def _writable_keystores(service: Service) -> Iterator[Volume]:
    named = service.environment.get("ROS_SECURITY_KEYSTORE")
    for volume in service.volumes:
        if volume.read_only or volume.source is None or volume.where.span.start < service.body.span.start:
            continue
        is_named = named is not None and named.value is not None and _holds(volume.target, str(named.value))
        if is_named or any("keystore" in part.lower() for part in (volume.source, volume.target or "")):
            yield volume


def _holds(target: Located | None, path: str) -> bool:
    """Whether a mount point is the path or a folder above it."""
    return target is not None and target != "/" and f"{path}/".startswith(f"{target.rstrip('/')}/")
