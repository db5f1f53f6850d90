"""An image is not pinned.

## What it finds
An `image:` without a tag, or with `:latest`, that nothing in the tree builds: neither a service, nor a bake file, nor a
script. Silent if no registry can hold the image (a name without a namespace that is not an official image), and
about digests, variables and containers that only sleep. Several services of one file with the same image are one
finding.

It is a warning where something pulls by itself: `pull_policy: always`, a service that keeps the others up to date such
as Watchtower, or `docker compose pull` and `--pull always` in a unit, play or crontab. Elsewhere it is an info.

## Why it matters on a robot
The next `docker compose pull` brings another ROS, another driver or another message definition to one robot of the
fleet, although nothing in the repository has changed.

## Bad
```yaml
nav:
  image: robot/nav:latest
```

## Good
```yaml
nav:
  image: robot/nav:2.3.1
```

## When to ignore it
When the file is only for development, and the robots run a pinned image.

## References
- robotics-security guide, container hardening
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Located
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import note
from bringup_lint.api import regex
from bringup_lint.api import rule
from bringup_lint.api.compose import Service
from bringup_lint.api.docker import can_be_pulled
from bringup_lint.api.docker import image_name

PULLS = regex(r"\bdocker(?:-compose)?\b[^\n#]{0,200}[ \t](?:pull\b|--pull[= ]always\b)", hints="pull")
UNATTENDED = ("systemd-unit", "systemd-dropin", "cron", "ansible")
"""Kinds of file whose commands run by themselves."""
UPDATES = ("watchtower", "wud", "diun", "ouroboros")
"""Images of programs that replace containers when their images change."""
BY_ITSELF = ("always", "daily", "weekly", "every_")


@rule("info", silent="Docker runs whatever image it has under the tag")
def latest(robot: Robot) -> Iterator[Finding]:
    pulls = any(source.judged and source.matches(PULLS) for source in robot.of_kind(*UNATTENDED))
    is_updated = pulls or any(map(_updates, robot.compose.services))
    for file in robot.compose.files:
        images: dict[str, list[Located]] = {}
        pulling: set[str] = set()
        for service in file.services:
            image = service.body.scalar("image")
            if image is not None and not _sleeps(service) and _is_pulled(robot, service, str(image.value)):
                images.setdefault(str(image.value), []).append(image.value)
                if (is_updated and not _updates(service)) or _pulls(service):
                    pulling.add(str(image.value))
        for name, (first, *others) in images.items():
            yield finding(
                first,
                f"The image '{name}' is not pinned: the next pull may bring another one",
                advice="name a version tag or a digest",
                related=[note(other, "the same image") for other in others if other.span != first.span],
                severity="warning" if name in pulling else None,
            )


def _updates(service: Service) -> bool:
    return image_name(str(service.image or "")).repository.rpartition("/")[2] in UPDATES


def _pulls(service: Service) -> bool:
    return str(service.scalar("pull_policy") or "").startswith(BY_ITSELF)


def _sleeps(service: Service) -> bool:
    """Whether the container only waits for somebody to work in it."""
    return " ".join(map(str, (*service.entrypoint, *service.command))).endswith("sleep infinity")


def _is_pulled(robot: Robot, service: Service, image: str) -> bool:
    """Whether a pull takes whatever the registry has at that time."""
    if service.build is not None or "$" in image or service.scalar("pull_policy") in ("never", "build"):
        return False
    if not image_name(image).is_latest or not can_be_pulled(image):
        return False
    return not robot.compose.images.is_built(image)
