"""A service names a volume, network or service that its compose file does not define.

## What it finds
Named volumes, networks and entries of `depends_on` in compose.yaml or docker-compose.yml without a definition, be it
in the file, in one that it includes, or in one that includes it or extends its services. Not judged are files that
include what is not in the tree, and files that have other compose files in their folder: those may define the rest.

## Why it matters on a robot
docker compose refuses the whole project ("refers to undefined volume", "depends on undefined service") and starts
nothing.

## Bad
```yaml
services:
  drive:
    image: registry.example/drive:1.2
    volumes: [maps:/maps]
```

## Good
```yaml
services:
  drive:
    image: registry.example/drive:1.2
    volumes: [maps:/maps]
volumes:
  maps:
```

## When to ignore it
When the file is always loaded together with one in another folder.

## References
- https://docs.docker.com/reference/compose-file/volumes/
- https://docs.docker.com/reference/compose-file/services/#depends_on
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import rule
from bringup_lint.api.compose import undefined_names


@rule(
    "error",
    symptoms=[
        "refers to undefined volume",
        "refers to undefined network",
        "depends on undefined service",
        "but no declaration was found in the volumes section",
        "depends on service * which is undefined",
        "refers to undefined secret",
        "refers to undefined config",
        "depends on unknown service",
    ],
)
def undefined_name(robot: Robot) -> Iterator[Finding]:
    for found in undefined_names(robot.compose):
        yield finding(
            found.name,
            f"Service '{found.service.name}' needs the {found.kind} '{found.name}', which is not defined: "
            "docker compose refuses the file",
            advice=f"define it in the section '{found.kind}s'",
        )
