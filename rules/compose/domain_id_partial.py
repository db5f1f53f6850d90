"""Only some ROS services set the domain or the middleware.

## What it finds
`ROS_DOMAIN_ID` or `RMW_IMPLEMENTATION` in some ROS services of a file, while another ROS service sets neither the
variable nor an env file. Only services whose images are the same, have the same namespace, or are official ROS images
are compared, and only those that one choice of `profiles` starts together. Silent for bridges between domains, such as
domain_bridge, the DDS Router and zenoh-bridge-ros2dds: they are in the domains that their own configuration names.
Silent, too, for a service that extends one of another file, and where its image, its command or a file that it mounts
gives the variable a value. A file that only interactive shells read, such as `.bashrc`, counts where the service runs
one.

## Why it matters on a robot
Nodes in different domains never see each other, and nodes with different middlewares do so only by luck. The
service without the variable runs in domain 0 with the default middleware.

## Bad
```yaml
nav:  {image: ros:jazzy, environment: {ROS_DOMAIN_ID: 42}}
slam: {image: ros:jazzy}
```

## Good
```yaml
x-ros: &ros {ROS_DOMAIN_ID: 42}
services:
  nav:  {image: ros:jazzy, environment: *ros}
  slam: {image: ros:jazzy, environment: *ros}
```

## When to ignore it
When the service is in another domain on purpose, for example a simulator.

## References
- https://github.com/hucebot/g1pilot/issues/30
"""

import posixpath
from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import note
from bringup_lint.api import regex
from bringup_lint.api import rule
from bringup_lint.api.compose import Beside
from bringup_lint.api.compose import Service
from bringup_lint.api.compose import Volume
from bringup_lint.api.docker import Instruction

_ALL = ("", "")
BRIDGE = regex(r"domain_bridge|dds-?router|zenoh-bridge")
ASSIGNED = regex(
    r"(?<![\w$\{])(?P<name>ROS_DOMAIN_ID|RMW_IMPLEMENTATION)"
    r"(?:=(?![\"']?\$\$\{?(?P=name)\b(?!:))|[\"']?(?:\]?[ \t]*=(?!=)|:[ \t]))"
    r"|SetEnvironmentVariable\([^\w\n]{0,40}(?P<set>ROS_DOMAIN_ID|RMW_IMPLEMENTATION)"
)
STARTUP = regex(r"bashrc|bash_profile|\.profile\b|zshrc|/etc/profile")
"""Files that only login shells and interactive ones read."""
INTERACTIVE = regex(
    r"(?:^|[\s/])(?:ba|z)?sh[ \t]+(?:-[a-z]*[il]|--login)|(?:^|[\s/])(?:ba|z)?sh[ \t]*$|\b(?:tmux|screen|byobu)\b"
)
DEFAULTS = {"ROS_DOMAIN_ID": "0", "RMW_IMPLEMENTATION": "rmw_fastrtps_cpp"}


@rule(
    "warning",
    confidence="medium",
    silent="services of different domains or middleware do not see each other, and neither side reports it",
)
def domain_id_partial(robot: Robot) -> Iterator[Finding]:
    for file in robot.compose.files:
        services = [] if file.source.template else [s for s in file.services if s.is_ros and s.is_whole]
        for name, default in DEFAULTS.items():
            setting = Comparable([service for service in services if name in service.environment])
            for service in services:
                if service.env_files or name in service.environment or _joins_domains(service):
                    continue
                first = setting.first(service)
                if first is None or _is_set_otherwise(robot, service, name):
                    continue
                value = first.environment[name].value
                if value is None or value in (default, f"${{{name}:-{default}}}"):
                    continue
                yield finding(
                    service.name,
                    f"Service '{service.name}' has no {name}, but '{first.name}' uses {value}",
                    advice="give all of them the same env_file or a common anchor",
                    related=[note(value, f"set for '{first.name}'")],
                )


def _joins_domains(service: Service) -> bool:
    """A bridge is in the domains that its own configuration names."""
    return any(BRIDGE.search(text) for text in (service.name, service.image or "", *service.scripts))


def _is_set_otherwise(robot: Robot, service: Service, name: str) -> bool:
    """Whether the service may get the variable from another file: from what it extends, from its image, or from what
    it mounts."""
    compose = robot.compose
    if compose.extends_elsewhere(service) or any(_assigns(text, name) for text in service.scripts):
        return True
    if any(_brings(robot, service, volume, name) for volume in service.volumes):
        return True
    stage = compose.stage(service)
    return stage is not None and any(_sets(service, step, name) for each in stage.chain for step in each.instructions)


def _sets(service: Service, step: Instruction, name: str) -> bool:
    """Whether a step of an image gives the variable to what the service runs; an ARG is for the build alone."""
    if step.name == "ENV" and step.value.startswith(f"{name} "):
        return True
    text = " ".join((step.value, *step.heredocs))
    if step.name == "ARG" or not _assigns(text, name):
        return False
    return STARTUP.search(text) is None or _reads(service, "")


def _brings(robot: Robot, service: Service, volume: Volume, name: str) -> bool:
    """Whether a mounted file gives the variable to what the service runs."""
    if volume.source is None or not volume.source.startswith("."):
        return False
    file, target = robot.tree.beside(service.source, volume.source), str(volume.target)
    if file is None or not file.once((_assigns, name), lambda: _assigns(file.said, name)):
        return False
    return STARTUP.search(target) is None or _reads(service, posixpath.basename(target))


def _assigns(text: str, name: str) -> bool:
    return name in text and any(name in (match["name"], match["set"]) for match in ASSIGNED.finditer(text))


def _reads(service: Service, file: str) -> bool:
    """Whether the service runs an interactive shell, or names the file that such a shell reads."""
    words = " ".join(service.scripts)
    if not words or INTERACTIVE.search(words):
        return True
    values = (each.value for each in service.environment.values() if each.value is not None)
    return file != "" and any(file in text for text in (words, *values))


class Comparable:
    """Some services, and which of them can be compared with others: those whose image adds no setting of its own, as it
    is the same, an official one, or of the same makers."""

    def __init__(self, services: list[Service]) -> None:
        groups: dict[tuple[str, str], list[int]] = {}
        for number, service in enumerate(services):
            image = service.image or ""
            for key in (_ALL, ("image", image), ("makers", image.rpartition("/")[0])):
                groups.setdefault(key, []).append(number)
        self._services = services
        self._groups = groups
        self._beside = {key: Beside(services[number] for number in group) for key, group in groups.items()}

    def first(self, service: Service) -> Service | None:
        """The first that runs together with another service, and whose image can be compared."""
        image = service.image or ""
        makers = image.rpartition("/")[0]
        keys = [("image", image), *([("makers", makers)] if makers else [])]
        if image.partition(":")[0] in ("ros", "osrf/ros"):
            keys = [_ALL]
        places = ((key, self._beside[key].first(service)) for key in keys if key in self._beside)
        found = min((self._groups[key][place] for key, place in places if place is not None), default=None)
        return None if found is None else self._services[found]
