"""Two services of a compose file give their containers one name.

## What it finds
The same `container_name:` at two services of one file that one `docker compose up` starts together: no profiles keep
them apart, and no script of the tree starts one of them alone.

## Why it matters on a robot
The names of containers are unique. Docker Compose refuses to start ("container name ... is already in use by
service"), older ones start one of the two, and the daemon refuses the other ("Conflict. The container name is already
in use").

## Bad
```yaml
services:
  front:
    image: registry.example.org/camera:1.4
    container_name: camera
  rear:
    image: registry.example.org/camera:1.4
    container_name: camera
```

## Good
```yaml
services:
  front:
    image: registry.example.org/camera:1.4
    container_name: camera_front
  rear:
    image: registry.example.org/camera:1.4
    container_name: camera_rear
```

## When to ignore it
When somebody always names the one service to start. Profiles say that, too.

## References
- https://docs.docker.com/reference/compose-file/services/#container_name
- compose-go, types/project.go, `CheckContainerNameUnicity()`
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import note
from bringup_lint.api import rule
from bringup_lint.api.compose import shared_names


@rule(
    "warning",
    symptoms=[
        "container name * is already in use by service *",
        "Conflict. The container name * is already in use by container",
    ],
)
def container_name_shared(robot: Robot) -> Iterator[Finding]:
    for shared in shared_names(robot.files, robot.compose):
        yield finding(
            shared.name,
            f"'{shared.owner.name}' has this name for its container, too: docker compose up does not start both",
            advice=f"give '{shared.other.name}' another name, or profiles to services of which one runs",
            related=[note(shared.first, f"the name of '{shared.owner.name}'")],
        )
