"""Nothing restarts a ROS container.

## What it finds
A ROS service without a restart policy, also one that starts ROS by the image that the tree builds. Services in a
profile, and services with `restart: "no"`, are not reported.
It is a warning for services that are the bring-up by their names or launch files, if one of them launches ROS with
devices of the robot, and nothing of the tree stays with the containers as `docker compose up` does without `-d`, nor
does its README or a comment tell people to run that. The only service of a tree needs no such name. Services of one
file are one finding.

## Why it matters on a robot
After a crash, or after a reboot of the robot, the container stays down.

## Bad
```yaml
nav:
  image: ros:jazzy
```

## Good
```yaml
nav:
  image: ros:jazzy
  restart: unless-stopped
```

## When to ignore it
When a systemd unit starts and restarts the service, or when it runs once and exits.

## References
- robot-bringup guide, checklist
"""

import re
from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import Source
from bringup_lint.api import finding
from bringup_lint.api import note
from bringup_lint.api import regex
from bringup_lint.api import rule
from bringup_lint.api.compose import Service
from bringup_lint.api.ros import is_simulation

GAP = r"(?:[ \t]|\\\r?\n){1,40}"
WORD = r"(?:[^\s\"]{0,200}\"[^\"\n]{0,200}\"[^\s\"]{0,200}|[^\s\"]{1,200})"
CALLS = regex(
    r"\bdocker(?:-compose|[ \t]+compose)"
    rf"(?:{GAP}(?:(?:-[fp]|--(?:file|profile|env-file|project-name|project-directory|progress|ansi|parallel)){GAP}{WORD}"
    rf"|--?[a-zA-Z]{WORD}|[\"']?\$\S{{1,100}})){{0,12}}{GAP}up(?![\w.-])(?![ \t]+(?:to|and[ \t]+running)\b)"
    r"(?!(?:\\\r?\n|[^\n;&|]){0,400}\s(?:-d|--detach|--wait)(?![\w-]))",
    hints="compose",
)
"""Commands that start containers and stay with them, also in comments, which tell people to run them."""
PAGE = regex(r"(?:^|/)README[^/]*$")
MOST = 200_000
BRINGUP = regex(r"bring_?up|robot\.launch", re.I)
BESIDE = regex(r"rviz|\bgcs|desktop|sleep infinity", re.I)
"""What simulates, shows or waits for somebody."""


@rule("info", symptoms=["exited with code 1"])
def restart_missing(robot: Robot) -> Iterator[Finding]:
    files: dict[Source, list[Service]] = {}
    for service in robot.compose.whole_services:
        if robot.runners.runs_ros2(service):
            files.setdefault(service.name.span.source, []).append(service)
    called = bool(files) and (robot.mentions(CALLS) or robot.tree.says(PAGE, MOST, CALLS))
    for services in files.values():
        lacking = [each for each in services if _is_lacking(each)]
        alone = len(files) == len(services) == 1
        driving = [each for each in lacking if not called and _drives(each, alone)]
        warned = [each for each in lacking if driving and (each in driving or _is_part(each))]
        yield from _of_file(warned, "warning")
        yield from _of_file([each for each in lacking if each not in warned], None)


def _is_lacking(service: Service) -> bool:
    return not service.restarts and service.restart is None and service.get("profiles") is None


def _of_file(services: list[Service], severity: str | None) -> Iterator[Finding]:
    if not services:
        return
    first, *others = services
    count = "1 other service" if len(others) == 1 else f"{len(others)} other services"
    more = f" and {count}" if others else ""
    yield finding(
        first.name,
        f"Nothing restarts '{first.name}'{more} after a crash or a reboot",
        advice="add restart: unless-stopped",
        related=[note(each.name, "nor this one") for each in others],
        severity=severity,
    )


def _drives(service: Service, alone: bool) -> bool:
    """Whether the service launches the robot itself, with its devices; the only one of a tree needs no name for it."""
    has_devices = bool(service.devices) or service.is_privileged
    return has_devices and service.launches is not None and (_is_named(service) or (alone and not _simulates(service)))


def _is_part(service: Service) -> bool:
    """Whether the service launches another part of the same bring-up."""
    return service.launches is not None and _is_named(service)


def _is_named(service: Service) -> bool:
    return BRINGUP.search(_words(service)) is not None and not _simulates(service)


def _simulates(service: Service) -> bool:
    return is_simulation(_words(service)) or BESIDE.search(_words(service)) is not None


def _words(service: Service) -> str:
    return " ".join([service.name, *service.command, *service.entrypoint])
