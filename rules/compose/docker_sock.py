"""A container controls the Docker daemon.

## What it finds
A volume of `docker.sock`, also when a variable names the socket of the host. A read-only mount makes no difference:
requests are written to the socket, not to the file. It is info for images whose only work is to manage containers, such
as Watchtower or Portainer.

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
# nothing: a service that only drives the robot does not need the socket
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
from bringup_lint.api.compose import Volume

PROXY = "put a socket proxy in between that lets only the requests pass that it needs"
ADVICE = f"remove the volume if the service does not manage containers; if it does, run nothing else in it, and {PROXY}"
OF_PRIVILEGED = (
    "remove privileged: true, which gives the same right, and then the volume if the service does not manage "
    f"containers; if it does, {PROXY}"
)
MANAGES = regex(
    r"(?:^|/)(?:watchtower|portainer(?:-[a-z]+)?|dozzle|diun|autoheal|docker-autoheal|lazydocker|yacht|dockge|traefik"
    r"|nginx-proxy|docker-gen|cadvisor|telegraf|promtail|docker-socket-proxy|openhands)(?=[:@]|$)"
)
"""Images that manage or watch containers, and work only through the socket."""


@rule("warning", silent="the socket works as it was mounted", tags=["CWE-250"])
def docker_sock(robot: Robot) -> Iterator[Finding]:
    for service in robot.compose.services:
        for volume in service.volumes:
            own = volume.where.span.start >= service.body.span.start
            if own and _is_socket(volume):
                rootless = ", unless the daemon is rootless" if str(volume.source).startswith("$") else ""
                yield finding(
                    volume.where,
                    f"Service '{service.name}' controls the Docker daemon: whoever breaks into it is root on the host"
                    f"{rootless}",
                    advice=OF_PRIVILEGED if service.is_privileged else ADVICE,
                    severity="info" if service.image is not None and MANAGES.search(service.image) else None,
                )


def _is_socket(volume: Volume) -> bool:
    """Whether the socket is mounted by its path, or a variable is mounted where the clients of Docker look for it."""
    if volume.source is None:
        return False
    by_variable = volume.source.startswith("$") and volume.target is not None
    return volume.source.endswith("/docker.sock") or (by_variable and str(volume.target).endswith("/run/docker.sock"))
