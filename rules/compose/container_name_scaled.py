"""A service with a fixed container name is to run more than once.

## What it finds
`container_name:` beside `scale:` or `deploy: {replicas: ...}` of more than one.

## Why it matters on a robot
The names of containers are unique. Docker Compose refuses the whole file ("can't set container_name and ... as
container name must be unique"), so that none of its services starts.

## Bad
```yaml
recorder:
  container_name: recorder
  deploy: {replicas: 2}
```

## Good
```yaml
recorder:
  deploy: {replicas: 2}
```

## When to ignore it
When the file is for `docker stack deploy` only, which ignores the name. Silent where the tree has this command,
or the service a `placement:`.

## References
- https://docs.docker.com/reference/compose-file/services/#container_name
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Located
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import note
from bringup_lint.api import regex
from bringup_lint.api import rule
from bringup_lint.api.compose import Service
from bringup_lint.api.yaml import Mapping

STACK = regex(r"\bdocker stack deploy\b", hints="deploy")
KEYS = ("container_name", "scale", "deploy")
COUNT = regex(r"0*(?:[2-9]|[1-9][0-9]+)")
"""More than one."""


@rule("error", symptoms=["can't set container_name and * as container name must be unique"])
def container_name_scaled(robot: Robot) -> Iterator[Finding]:
    if robot.mentions(STACK):
        return
    for service in robot.compose.services:
        name = service.scalar("container_name")
        count = _count(service) if name not in (None, "", "null", "~") and service.source.judged else None
        if name is not None and count is not None and not robot.compose.is_set_elsewhere(service, *KEYS):
            yield finding(
                name,
                f"'{name}' can be the name of one container only, and there are to be {count}: docker compose "
                "refuses the file",
                advice="leave container_name out",
                related=[note(count, "the number of containers")],
            )


def _count(service: Service) -> Located | None:
    """The number of containers, where it is more than one."""
    deploy = service.get("deploy")
    if isinstance(deploy, Mapping) and deploy.get("placement") is not None:
        return None
    replicas = deploy.scalar("replicas") if isinstance(deploy, Mapping) else None
    given = replicas.value if replicas is not None else service.scalar("scale")
    return given if given is not None and COUNT.fullmatch(given) else None
