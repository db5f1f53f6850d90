"""A service starts a container in the background and loses sight of it.

## What it finds
`docker run -d`, `docker start` or `docker compose up -d` as the main process of a service that is not
Type=oneshot or Type=forking. With RemainAfterExit=, containers with a restart policy of their own are not
reported. It is an error where ExecStop= takes these containers down however the service ended.

## Why it matters on a robot
The client exits as soon as the container runs. systemd takes that for the end of the service: it runs
ExecStop= at once, or with RemainAfterExit=yes shows the service as active whatever becomes of the container.
A crash of the robot's software goes unnoticed, and Restart= has no effect.

## Bad
```ini
[Service]
RemainAfterExit=yes
ExecStart=/usr/bin/docker run -d --name base rover/base
```

## Good
```ini
[Service]
ExecStart=/usr/bin/docker run --rm --name base rover/base
ExecStop=/usr/bin/docker stop base
Restart=always
RestartSec=5
```

## When to ignore it
When something else, such as a health check with an alarm, watches the container.

## References
- systemd.service(5), RemainAfterExit= and ExecStop=
- docker run, `--detach`
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Located
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import note
from bringup_lint.api import rule
from bringup_lint.api.systemd import DockerCommand
from bringup_lint.api.systemd import Unit
from bringup_lint.api.systemd import docker_starts
from bringup_lint.api.systemd import docker_stop


@rule("warning", silent="the docker client ends with success")
def docker_run_detached(robot: Robot) -> Iterator[Finding]:
    for unit in robot.units.running("docker"):
        remains = unit.flag("RemainAfterExit")
        if unit.get("Type") in ("oneshot", "forking") or remains.unknown or unit.uncertain:
            continue
        started = robot.units.started(unit)
        last = [start for process in started for start in docker_starts(process) if _is_main(start)]
        if len(started) != 1 or not last or not last[-1].detached:
            continue
        start = last[-1]
        if remains:
            if not start.compose and not start.restarted_by_docker:
                yield finding(
                    start.verb,
                    f"{unit.name} stays active whatever becomes of the container: systemd sees only the client, which "
                    "exits",
                    advice="run it in the foreground, without -d and RemainAfterExit=",
                    related=[note(remains.where, "keeps the service active")],
                )
            continue
        stop = _stop(robot, unit, start)
        yield finding(
            start.verb,
            f"The client exits as soon as the container runs: {unit.name} ends at once, and "
            + (
                f"its ExecStop= takes the container down{_again(unit)}"
                if stop
                else "systemd does not watch the container"
            ),
            advice="run it in the foreground, without -d",
            related=[note(stop, "runs when the client has exited")] if stop is not None else [],
            severity="error" if stop is not None else None,
        )


def _stop(robot: Robot, unit: Unit, start: DockerCommand) -> Located | None:
    """What takes the containers down when the service ends."""
    ends = (each for each in robot.units.processes(unit) if each.key == "ExecStop")
    return next((word for each in ends if (word := docker_stop(start, each)) is not None), None)


def _again(unit: Unit) -> str:
    restart = unit.get("Restart")
    return f", and Restart={restart} repeats both" if restart in ("always", "on-success") else ""


def _is_main(start: DockerCommand) -> bool:
    """Whether the command is what the service ends with: its own command line, or the last one of its shell."""
    return start.step.depth == 0 or (start.step.last and not start.step.command.background)
