"""Two services publish the same port of the host.

## What it finds
Two services that start together and whose `ports:` ask for one port of the host, or one service that publishes two of
its ports under one number; also where the second entry is in the override file that docker compose reads by itself.

Not reported: services on the host network, of different `profiles`, for simulation or development, without a container
(`replicas: 0`), or that a command of the tree starts by their name; addresses that differ, and ports from variables.

## Why it matters on a robot
The second container does not start: "Bind for 0.0.0.0:8080 failed: port is already allocated". Which of them is the
second one changes from boot to boot.

## Bad
```yaml
services:
  video: {image: tug/video:1.2, ports: ["8080:8080"]}
  panel: {image: nginx:1.27, ports: ["8080:80"]}
```

## Good
```yaml
services:
  video: {image: tug/video:1.2, ports: ["8080:8080"]}
  panel: {image: nginx:1.27, ports: ["8081:80"]}
```

## When to ignore it
When only one of the services is ever started.

## References
- https://docs.docker.com/reference/compose-file/services/#ports
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import note
from bringup_lint.api import rule
from bringup_lint.api.compose import taken_ports


@rule("error", confidence="medium", symptoms=["Bind for * failed: port is already allocated"])
def port_taken(robot: Robot) -> Iterator[Finding]:
    for taken in taken_ports(robot.files, robot.compose):
        is_one = taken.owner is taken.other
        end = "it does not start" if is_one else "only one of the two starts"
        yield finding(
            taken.second.where,
            f"Port {taken.port} of the host is already published by '{taken.owner.name}': {end}",
            advice="give one of them another port of the host",
            related=[note(taken.first.where, "published here")],
        )
