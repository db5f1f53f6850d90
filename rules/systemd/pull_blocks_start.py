"""A service that starts at boot pulls its image first, and fails without the Internet.

## What it finds
`docker pull`, `docker compose pull` and `--pull=always` in the ExecStartPre= or ExecStart= of a service that a boot
target starts, without `-` before the command line and without anything that lets it fail. Silent for units that only
pull, and for images that are pulled where they are missing.

## Why it matters on a robot
In a field, at a customer or with a broken router, the pull fails, and systemd does not start the robot's software
although the image is there. With Restart= it tries again until the network is back.

## Bad
```ini
[Service]
ExecStartPre=/usr/bin/docker compose pull
ExecStart=/usr/bin/docker compose up
```

## Good
```ini
[Service]
ExecStartPre=-/usr/bin/docker compose pull
ExecStart=/usr/bin/docker compose up
```

## When to ignore it
When the robot must not run with an older image.

## References
- systemd.service(5), ExecStartPre= and the prefix `-`
- docker compose pull, `--ignore-pull-failures`
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Located
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import rule
from bringup_lint.api.systemd import Process
from bringup_lint.api.systemd import docker_pulls

KEYS = ("ExecStartPre", "ExecStart")


@rule(
    "warning",
    symptoms=["failed to resolve reference", "dial tcp: lookup registry-1.docker.io"],
)
def pull_blocks_start(robot: Robot) -> Iterator[Finding]:
    if not robot.may_hold("docker"):
        return
    for unit in robot.units.services:
        if unit.uncertain or not unit.fragment or not any(robot.units.wanted_by(unit)):
            continue
        processes = [each for each in robot.units.processes(unit) if each.key in KEYS]
        if all(_needed(each) == "pull" for each in processes):
            continue  # it only brings the images up to date
        for process in processes:
            pull = _needed(process) if "-" not in process.prefixes else None
            if pull is not None:
                yield finding(
                    pull,
                    f"{unit.name} asks the registry at every start: without the Internet it does not start",
                    advice="write - before the command line of the pull, or update by a timer"
                    if process.key == "ExecStartPre"
                    else "pull by a timer, and start with the image that is there",
                )
                break


def _needed(process: Process) -> Located | None:
    """The first pull of a command line whose failure ends it, whatever ran before."""
    after = zip(("", *(step.command.ends for step in process.steps)), process.steps)
    steps = (
        step
        for before, step in after
        if before != "||" and step.script is None and not step.command.depth and step.command.ends in ("", "&&")
    )
    unguarded = {word.span for step in steps for word in step.command.words}
    return next((word for word in docker_pulls(process) if word.span in unguarded), None)
