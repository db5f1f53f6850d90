"""A database has no volume of its own.

## What it finds
A service with the official image of a database (PostgreSQL, MySQL, MariaDB, MongoDB, InfluxDB, CouchDB) that restarts
by itself or has a fixed name for its container, and of which no volume covers the folder of the data.
Silent where its command is another program, such as a backup, and where it has a configuration of its own and another
volume.

## Why it matters on a robot
The image makes a volume without a name. After `docker compose down`, and on the next robot, nothing finds it again, and
the database begins empty: maps, tasks, measurements and accounts are gone.

## Bad
```yaml
services:
  tasks:
    image: postgres:16
    restart: unless-stopped
```

## Good
```yaml
services:
  tasks:
    image: postgres:16
    restart: unless-stopped
    volumes:
      - tasks:/var/lib/postgresql/data
volumes:
  tasks:
```

## When to ignore it
When the data is filled in anew at every start.

## References
- https://hub.docker.com/_/postgres, "Where to Store Data", and the same of the other images
- https://docs.docker.com/reference/cli/docker/compose/down/
"""

import posixpath
import re
from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import note
from bringup_lint.api import regex
from bringup_lint.api import rule
from bringup_lint.api.compose import Service
from bringup_lint.api.docker import image_name
from bringup_lint.api.shell import program_name

FOLDERS = {
    "postgres": "/var/lib/postgresql",
    "mysql": "/var/lib/mysql",
    "mariadb": "/var/lib/mysql",
    "mongo": "/data/db",
    "influxdb": "/var/lib/influxdb",
    "couchdb": "/opt/couchdb/data",
}
SERVERS = ("docker-entrypoint.sh", "postgres", "mysqld", "mariadbd", "mongod", "influxd")
KEYS = ("extends", "volumes_from")
"""What may bring a volume."""
MOVED = regex(r"PGDATA|INFLUXD_ENGINE_PATH|INFLUXDB_DATA_DIR|data-?_?dir|dbpath", re.I)
"""What takes another folder for the data."""


@rule("warning", silent="the database makes an empty one, as at its first start")
def database_unkept(robot: Robot) -> Iterator[Finding]:
    kept: dict[tuple[str, str], bool] = {}
    for service in robot.compose.whole_services:
        image = service.image if service.source.judged and service.build is None else None
        folder = FOLDERS.get(image_name(image).repository) if image is not None else None
        if (
            image is None
            or folder is None
            or not _is_server(service)
            or not (service.restarts or service.get("container_name"))
        ):
            continue
        known = (str(service.name), folder)
        if known not in kept:
            kept[known] = any(_may_keep(each, folder) for each in robot.compose.services_called(service.name))
        if not kept[known]:
            yield finding(
                service.name,
                "No volume covers the data of this database: after docker compose down, it begins empty",
                advice=f"mount a volume with a name at {folder}",
                related=[note(image, "keeps its data in a volume without a name")],
            )


def _is_server(service: Service) -> bool:
    """Whether the container runs the database, and not a client of it."""
    first = (*service.entrypoint[:1], *service.command[:1])
    return all(word.startswith("-") or program_name(word) in SERVERS for word in first)


def _may_keep(service: Service, folder: str) -> bool:
    if any(service.get(key) is not None for key in KEYS) or MOVED.search(service.body.span.text):
        return True
    targets = [*(str(each.target) for each in service.volumes), *map(str, service.tmpfs)]
    if any("$" in each or _are_nested(each, folder) for each in targets):
        return True
    others = [each for each in targets if not each.startswith(("/etc/", "/docker-entrypoint-initdb.d"))]
    return bool(others) and any(each.startswith("/etc/") for each in targets)


def _are_nested(target: str, folder: str) -> bool:
    one, other = posixpath.join(target, ""), posixpath.join(folder, "")
    return one.startswith(other.rstrip("/")) or other.startswith(one)
