"""A service mounts two things at one path.

## What it finds
Two entries in the `volumes:` of one service with the same path in the container and different sources. It is info
where the entry that is dropped names a volume that no compose file of the tree defines: it would bring nothing.

## Why it matters on a robot
docker compose keeps the last entry for a path and drops the others without a message; older versions refuse the service
with "Duplicate mount point". What the dropped entry was to bring, such as maps, the display or a configuration, is not
in the container.

## Bad
```yaml
volumes:
  - ./maps:/maps
  - records:/maps
```

## Good
```yaml
volumes:
  - ./maps:/maps
  - records:/records
```

## When to ignore it
When the first entry is kept for a change that somebody makes by hand.

## References
- https://github.com/compose-spec/compose-go, package override: `EnforceUnicity`
- https://docs.docker.com/reference/compose-file/services/#volumes
"""

import posixpath
from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import note
from bringup_lint.api import regex
from bringup_lint.api import rule
from bringup_lint.api.compose import Service
from bringup_lint.api.compose import Volume
from bringup_lint.api.compose import defined_names

NAME = regex(r"[A-Za-z0-9][\w.-]+")
"""Of a volume, other than a path."""


@rule("warning", symptoms=["Duplicate mount point: *"])
def target_twice(robot: Robot) -> Iterator[Finding]:
    defined = defined_names(robot.compose.files, "volume")
    for service in robot.compose.services:
        yield from _of_service(service, defined)


def _of_service(service: Service, defined: set[str]) -> Iterator[Finding]:
    last: dict[str, Volume] = {}
    for volume in reversed(service.volumes):
        path = str(volume.target).rstrip("/")
        if not service.body.span.start <= volume.where.span.start < service.body.span.end or "$" in path:
            continue
        kept = last.setdefault(path, volume)
        if volume.source is None or kept.source is None:
            continue
        if posixpath.normpath(kept.source) != posixpath.normpath(volume.source):
            is_named = volume.kind in ("", "volume") and NAME.fullmatch(volume.source) is not None
            is_left = is_named and volume.source not in defined
            yield finding(
                volume.where,
                f"docker compose keeps only the last mount at {path}: {volume.source} does not get into "
                f"'{service.name}'",
                advice=f"remove the entry: no volume {volume.source} is defined"
                if is_left
                else "remove one of the two, or give it a path of its own",
                related=[note(kept.where, "this one is mounted")],
                severity="info" if is_left else None,
            )
