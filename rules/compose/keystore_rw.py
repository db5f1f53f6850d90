"""A container can change the SROS2 keystore.

## What it finds
A keystore (the target of `ROS_SECURITY_KEYSTORE` or a folder above it, or a path with `keystore` in it) that is
mounted without `ro`.

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
from bringup_lint.api import rule


@rule("warning", fix="safe", tags=["CWE-732"])
def keystore_rw(robot: Robot) -> Iterator[Finding]:
    for service in robot.compose.services:
        named = service.environment.get("ROS_SECURITY_KEYSTORE")
        for volume in service.volumes:
            if volume.read_only or volume.source is None or volume.where.span.start < service.body.span.start:
                continue
            is_named = named is not None and named.value is not None and _holds(volume.target, str(named.value))
            if is_named or any("keystore" in part.lower() for part in (volume.source, volume.target or "")):
                short = volume.where.count(":") == 1 and "$" not in volume.where
                yield finding(
                    volume.where,
                    f"'{service.name}' can change the keystore",
                    advice="mount it read-only, and only the enclave that the service needs",
                    fix=fix("mount it read-only", (volume.where, f"{volume.where}:ro")) if short else None,
                )


def _holds(target: Located | None, path: str) -> bool:
    """Whether a mount point is the path or a folder above it."""
    return target is not None and target != "/" and f"{path}/".startswith(f"{target.rstrip('/')}/")
