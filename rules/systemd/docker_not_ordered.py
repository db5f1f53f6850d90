"""A service that starts containers is not ordered after Docker.

## What it finds
A service that runs `docker run`, `docker start` or `docker compose up` and that nothing orders after
docker.service or docker.socket by name. Services that wait for the daemon themselves, with `docker info` for
example, are not reported.

## Why it matters on a robot
At boot the client can run before the daemon is ready, and the robot's software does not start. At shutdown
systemd can stop the daemon first, so ExecStop= fails and the containers are killed.

## Bad
```ini
[Service]
ExecStart=/usr/bin/docker run --rm --name base rover/base
```

## Good
```ini
[Unit]
Requires=docker.service
After=docker.service

[Service]
ExecStart=/usr/bin/docker run --rm --name base rover/base
```

## When to ignore it
When docker.socket starts the daemon on demand, and the order at shutdown does not matter.

## References
- systemd.unit(5), After= and Requires=
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Fix
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import fix
from bringup_lint.api import note
from bringup_lint.api import rule
from bringup_lint.api.systemd import Unit
from bringup_lint.api.systemd import Units
from bringup_lint.api.systemd import docker_starts

_DAEMON = ("docker.service", "docker.socket", "snap.docker.dockerd.service")
_TARGETS = ("multi-user.target", "graphical.target", "default.target")
"""What is ordered after the daemon, which its package enables for multi-user.target."""
_ASKS = ("docker info", "docker ps", "docker version", "is-active docker", "start docker", "docker.sock")


@rule("warning", fix="unsafe", symptoms=["Cannot connect to the Docker daemon"])
def docker_not_ordered(robot: Robot) -> Iterator[Finding]:
    units = robot.units
    for unit in units.running("docker"):
        if unit.manager == "user" or unit.unsure_of("After", "Requires", "Wants", "BindsTo"):
            continue
        if any(text in script for process in units.processes(unit) for script in process.texts for text in _ASKS):
            continue
        found = [start for process in units.processes(unit) for start in docker_starts(process)]
        starts = [start for start in found if start.process.key in ("ExecStart", "ExecStartPre")]
        if not starts or _waits_for(unit, units):
            continue
        yield finding(
            starts[0].process.program,
            f"Nothing orders {unit.name} after docker.service: at boot the daemon may not be ready, and at shutdown it "
            "may stop first",
            advice="add Requires=docker.service and After=docker.service",
            related=[note(starts[0].verb, "asks the daemon for a container")],
            fix=_fix(unit),
            confidence="medium",
        )


def _waits_for(unit: Unit, units: Units) -> bool:
    """Whether lines of the tree order the unit after the daemon, and not only all sockets do, or after a target that
    is ordered after the daemon."""
    direct = (units.waits_for(unit, daemon) for daemon in _DAEMON)
    through = (units.waits_for(unit, target) for target in _TARGETS)
    return any(edge is not None and edge.where is not None for edge in (*direct, *through))


def _fix(unit: Unit) -> Fix | None:
    if not unit.editable:
        return None
    return fix("order it after Docker", unit.new_line("Unit", "Requires=docker.service\nAfter=docker.service"))
