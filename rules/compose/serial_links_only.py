"""A container gets the stable names of devices and not the devices.

## What it finds
A bind mount of `/dev/serial`, `/dev/v4l` or a folder below, such as `/dev/serial/by-id`, in a service that is not
privileged and maps neither `/dev` nor a device of that kind. It is info where a page of the tree tells people to start
the image with `docker run` and `--device`.

## Why it matters on a robot
The folder holds links to `../../ttyUSB0`. In the container there is no `/dev/ttyUSB0`, so every link leads nowhere and
the driver ends with "No such file or directory".

## Bad
```yaml
volumes:
  - /dev/serial/by-id:/dev/serial/by-id
```

## Good
```yaml
devices:
  - /dev/serial/by-id/usb-heron_imu-if00:/dev/imu
```

## When to ignore it
When the container only lists the names.

## References
- https://docs.docker.com/reference/compose-file/services/#devices
- udev(7), "SYMLINK"
"""

import re
from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Located
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import regex
from bringup_lint.api import rule
from bringup_lint.api.compose import Service
from bringup_lint.api.compose import Volume
from bringup_lint.api.docker import image_name

LINKS = {
    regex(r"/dev/serial(?:/by-(?:id|path))?/?"): regex(r"/dev/?$|/dev/(?:tty|serial)|.*\$"),
    regex(r"/dev/v4l(?:/by-(?:id|path))?/?"): regex(r"/dev/?$|/dev/(?:video|v4l|media)|.*\$"),
}
"""Folders of links -> what brings a device that they may lead to."""


PAGE = regex(r"\.(?:md|rst|txt|adoc)$")
MOST = 200_000
RUN = regex(r"\bdocker[ \t]+(?:container[ \t]+)?run[ \t\\](?:\\\n|[^\n]){0,2000}", hints="docker")
"""A command of people that starts a container, with its continued lines."""
GIVEN = regex(r"--device[ =][\"']?/dev/(?P<kind>tty|serial|video|v4l|media)", hints="--device")
"""How they add a device."""
WORD = regex(r"[^\s`\"']+")


@rule("error", symptoms=["could not open port /dev/serial/by-id", "No such file or directory: '/dev/serial/by-id"])
def serial_links_only(robot: Robot) -> Iterator[Finding]:
    by_hand: set[tuple[str, str | None]] | None = None
    for service in robot.compose.whole_services:
        if service.source.judged and not service.is_privileged:
            for folder, brings in _without_devices(service):
                if by_hand is None:
                    by_hand = set(_given_by_hand(robot))
                image = image_name(service.image).repository if service.image is not None else None
                is_given = any(brings.match(path) for path, given in by_hand if given == image)
                yield finding(
                    folder,
                    f"{folder} holds links only: the devices that they lead to are not in the container",
                    advice="map the device itself below devices:, by its link",
                    severity="info" if is_given else None,
                )


def _given_by_hand(robot: Robot) -> Iterator[tuple[str, str]]:
    """The devices that pages tell people to give to an image which they start themselves, each with what may be the
    image."""
    for text in robot.tree.pages(PAGE, MOST):
        for match in RUN.finditer(text):
            for given in GIVEN.finditer(match[0]):
                for word in WORD.findall(match[0]):
                    yield f"/dev/{given['kind']}", image_name(word).repository


def _without_devices(service: Service) -> Iterator[tuple[Located, re.Pattern[str]]]:
    """The mounted folders of links for which the service has no device, each with what would bring one."""
    volumes = [volume.source for volume in service.volumes if volume.source is not None]
    given = [str(volume.source) for volume in service.volumes if _may_be_device(volume)]
    given += [str(device.host) for device in service.devices]
    for pattern, brings in LINKS.items():
        mounted = [source for source in volumes if pattern.fullmatch(source)]
        others = [path for path in given if not pattern.fullmatch(path)]
        if mounted and not any(brings.match(path) for path in others):
            yield mounted[0], brings


def _may_be_device(volume: Volume) -> bool:
    """Whether a volume may bring devices: what is mounted elsewhere than in /dev is a folder of other files."""
    target = str(volume.target or "")
    return volume.source is not None and target.startswith(("/dev", "$"))
