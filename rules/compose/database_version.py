"""A pull gives a database a version that does not read its data.

## What it finds
A service with the official image of PostgreSQL under a tag that names no version (none, `latest`, `alpine`,
`bookworm`), with a volume for the data.

## Why it matters on a robot
Each major version of PostgreSQL has its own format of data, and refuses that of another one: "database files are
incompatible with server". The first pull after a new release, as on a robot that is set up again from a backup, leaves
the database down. From 18 on the image also refuses a volume at `/var/lib/postgresql/data`.

## Bad
```yaml
services:
  tasks:
    image: postgres
    volumes:
      - tasks:/var/lib/postgresql/data
volumes:
  tasks:
```

## Good
```yaml
services:
  tasks:
    image: postgres:17
    volumes:
      - tasks:/var/lib/postgresql/data
volumes:
  tasks:
```

## When to ignore it
When nothing is lost with the data.

## References
- https://www.postgresql.org/docs/current/upgrading.html
- https://hub.docker.com/_/postgres, "PGDATA"
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import note
from bringup_lint.api import regex
from bringup_lint.api import rule
from bringup_lint.api.compose import Volume
from bringup_lint.api.docker import image_name

FOLDER = "/var/lib/postgresql"
FLOATS = regex(r"(?:latest|alpine(?:\d+\.\d+)?|bullseye|bookworm|trixie)?")


@rule("warning", symptoms=["database files are incompatible with server"])
def database_version(robot: Robot) -> Iterator[Finding]:
    for service in robot.compose.services:
        image = service.image
        if image is None or service.build is not None or not service.source.judged:
            continue
        name = image_name(image)
        if name.repository != "postgres" or name.digest or FLOATS.fullmatch(name.tag) is None:
            continue
        kept = next((each for each in service.volumes if str(each.target).startswith(FOLDER) and _lasts(each)), None)
        if kept is not None:
            yield finding(
                kept.where,
                f"'{image}' may be the next major version after a pull, which does not read the data of an older one",
                advice="name the major version in the image, such as postgres:17",
                related=[note(image, "names no version")],
            )


def _lasts(volume: Volume) -> bool:
    """Whether it is not one in memory, of which only the place in the container is written."""
    return volume.source is not None or volume.where is not volume.target
