"""A container is privileged.

## What it finds
`privileged: true`. A mount of the whole `/dev` in the same service belongs to the finding. The services of a
tree are one finding, and those that enter the namespaces of the host with `pid: host` and nsenter are another one: for
them, no shorter list of rights would do. It is info where a comment says which devices need it, for a place to
work in: a terminal or a desktop without a command of the robot, and for the driver of a ZED X camera, which mounts its
daemon: Stereolabs documents no list of devices that would do.

## Why it matters on a robot
The container can do everything on the host: load modules, write to every disk, read every key. A flaw in one node
compromises the robot.

## Bad
```yaml
driver:
  image: robot/driver:1.2
  privileged: true
```

## Good
```yaml
driver:
  image: robot/driver:1.2
  devices: [/dev/robot/lidar]
  cap_add: [SYS_NICE]
```

## When to ignore it
When the service is a tool for commissioning that never runs in operation.

## References
- robotics-security guide, container hardening
- https://www.stereolabs.com/docs/cameras/zed-x-one/zed-x-one-and-docker/
- CWE-250
"""

import re
from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Purpose
from bringup_lint.api import Related
from bringup_lint.api import Robot
from bringup_lint.api import Span
from bringup_lint.api import finding
from bringup_lint.api import note
from bringup_lint.api import regex
from bringup_lint.api import rule
from bringup_lint.api.compose import Service
from bringup_lint.api.compose import is_workplace

REASON = regex(r"\bprivileged\b.*\b(?:to|because|so that|for|since|as)\b.*(?:\bdevices?\b|\busb\b|/dev\b)", re.I)
MOST = 20
ZED_X = regex(r"/zed_x_daemon\.service$")
ENTERS = regex(r"\bnsenter\b[^\n]{0,200}?\s(?:-t|--target)[ =]?1\b", hints="nsenter")
TERMINAL = regex(r"\b(?:ttyd|wetty|gotty|shellinabox)")
OF_HOST = "let a systemd unit of the host run them instead"
OF_TERMINAL = "let it ask for a password and listen to 127.0.0.1 alone, or start it only while somebody needs it"
OF_DEVICES = "list what it needs instead: devices:, device_cgroup_rules:, cap_add:"
OF_CLASSES = (
    "name the devices below devices:; for those that come and go, keep the mount of /dev and allow their classes "
    "instead, for example device_cgroup_rules: ['c 188:* rmw'] for ttyUSB"
)


@rule("warning", silent="Docker does not report what a container may do", tags=["CWE-250"])
def privileged(robot: Robot) -> Iterator[Finding]:
    places: dict[Span, list[Service]] = {}
    for service in robot.compose.services:
        key = service.key("privileged")
        if key is not None and service.is_privileged:
            places.setdefault(key.span, []).append(service)
    alike: dict[tuple[Purpose, str | None], dict[Span, list[Service]]] = {}
    for place, services in places.items():
        if _is_meant(robot, place, services):
            yield _report({place: services}, "info")
        else:
            alike.setdefault((robot.purpose(place), _advice_of_host(services)), {})[place] = services
    for (_, advice), found in alike.items():
        yield _report(found, None, advice)


def _report(found: dict[Span, list[Service]], severity: str | None, of_host: str | None = None) -> Finding:
    """One finding for all places of a tree; with the advice for those that run commands on the host."""
    (place, services), *others = found.items()
    first, more = services[0].name, sum(map(len, found.values())) - 1
    who = f"Service '{first}'{f' (and {more} more)' if more else ''}"
    volumes = (volume for each in found.values() for service in each for volume in service.volumes)
    reaches = "reaches" if of_host == OF_TERMINAL else "breaks into"
    all_devices = any(volume.source == "/dev" for volume in volumes)
    return finding(
        place,
        f"{who} runs commands as root on the host, outside of its container: so does whoever {reaches} it"
        if of_host
        else f"{who} is privileged: whoever becomes root in it is root on the host",
        advice=of_host or (OF_CLASSES if all_devices else OF_DEVICES),
        related=[
            *_named(services),
            *_device_mounts(services),
            *(note(other, f"so is '{each[0].name}'") for other, each in others[:MOST]),
        ],
        severity=severity,
    )


def _is_meant(robot: Robot, place: Span, services: list[Service]) -> bool:
    """Whether a comment at the line says which devices need it, or the containers only wait for somebody or drive what
    needs it."""
    if all(is_workplace(robot.compose, service) or _drives_zed_x(service) for service in services):
        return True
    return REASON.search(" ".join(place.source.comments_at(place.line))) is not None


def _drives_zed_x(service: Service) -> bool:
    return any(ZED_X.search(volume.source or "") for volume in service.volumes)


def _advice_of_host(services: list[Service]) -> str | None:
    """The advice for services that all run commands on the host."""
    if not all(map(_enters_host, services)):
        return None
    return OF_TERMINAL if all(map(_is_terminal, services)) else OF_HOST


def _enters_host(service: Service) -> bool:
    """Whether what it runs is in the namespaces of the first process of the host, which it sees."""
    return service.scalar("pid") == "host" and ENTERS.search(" ".join(service.scripts)) is not None


def _is_terminal(service: Service) -> bool:
    """Whether people reach its shell with a browser."""
    return any(TERMINAL.search(text) for text in (service.image or "", *service.scripts))


def _named(services: list[Service]) -> list[Related]:
    return [note(service.name, "is it too") for service in services[1:]]


def _device_mounts(services: list[Service]) -> Iterator[Related]:
    for service in services:
        mounts = [volume.where for volume in service.volumes if volume.source == "/dev"]
        yield from (note(mount, "which includes every device") for mount in mounts[:1])
