"""A container controls the Docker daemon.

## What it finds
A volume of `docker.sock`. A read-only mount makes no difference: requests are written to the socket, not to the
file. It is info for images whose only work is to manage containers, such as Watchtower or Portainer.

## Why it matters on a robot
Anybody in the container can start another container that mounts the host's root file system, and so is root on the
robot.

## Bad
```yaml
volumes:
  - /var/run/docker.sock:/var/run/docker.sock
```

## Good
```yaml
# nothing: no service needs the socket to drive a robot
```

## When to ignore it
When the service is the fleet's own update agent and nothing else runs in its container.

## References
- robotics-security guide, container hardening
- CWE-250
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import regex
from bringup_lint.api import rule

MANAGES = regex(
    r"(?:^|/)(?:watchtower|portainer(?:-[a-z]+)?|dozzle|diun|autoheal|docker-autoheal|lazydocker)(?=[:@]|$)"
)
"""Images that do nothing but manage containers, and work only through the socket."""


@rule("warning", tags=["CWE-250"])
def docker_sock(robot: Robot) -> Iterator[Finding]:
    for service in robot.compose.services:
        for volume in service.volumes:
            own = volume.where.span.start >= service.body.span.start
            if own and volume.source is not None and volume.source.endswith("/docker.sock"):
                yield finding(
                    volume.where,
                    f"Service '{service.name}' controls the Docker daemon, and with it the host",
                    advice="remove the volume; update containers from outside",
                    severity="info" if service.image is not None and MANAGES.search(service.image) else None,
                )
