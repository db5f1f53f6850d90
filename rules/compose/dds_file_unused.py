"""A service mounts a file of DDS settings, and nothing in its container names it.

## What it finds
A mount of `cyclonedds.xml` or `fastdds.xml` (any name with `cyclone`, `fastdds`, `fastrtps` or `dds_`) into a service
with that middleware which sets neither `CYCLONEDDS_URI` nor `FASTRTPS_DEFAULT_PROFILES_FILE`,
- where another service of the tree mounts the file at the same path and does set the variable;
- where the image is built by the tree, and neither its Dockerfile nor any script speaks of the variable.

Silent where the command speaks of the variable or the file, where a launch file or a script that may be of the
container sets it, and where an `env_file:` is not in the tree.

## Why it matters on a robot
Only the variable makes the library read a file. The nodes of this service keep all interfaces, multicast and the small
buffers of the defaults, and may not find those that do read it.

## Bad
```yaml
environment:
  RMW_IMPLEMENTATION: rmw_cyclonedds_cpp
volumes:
  - ./config/cyclonedds.xml:/cyclonedds.xml:ro
```

## Good
```yaml
environment:
  RMW_IMPLEMENTATION: rmw_cyclonedds_cpp
  CYCLONEDDS_URI: file:///cyclonedds.xml
volumes:
  - ./config/cyclonedds.xml:/cyclonedds.xml:ro
```

## When to ignore it
When a file that the image already has sets the variable.

## References
- https://docs.ros.org/en/jazzy/Installation/RMW-Implementations/DDS-Implementations/Working-with-Eclipse-CycloneDDS.html
- https://fast-dds.docs.eprosima.com/en/latest/fastdds/env_vars/env_vars.html
"""

import posixpath
from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Located
from bringup_lint.api import NamedTuple
from bringup_lint.api import Robot
from bringup_lint.api import Source
from bringup_lint.api import finding
from bringup_lint.api import note
from bringup_lint.api import regex
from bringup_lint.api import rule
from bringup_lint.api.compose import Service
from bringup_lint.api.docker import environment_of

SHELLS = regex(r"(?:^|/)[^/]*(?:bashrc|profile|bash_aliases|zshrc|entrypoint)[^/]*$|\.(?:sh|bash|zsh|env|mk)$")
READ = 100_000
OF_ITSELF = regex(r"(?:^|/)DEFAULT_FAST(?:RTPS|DDS)_PROFILES\.xml$")
"""Fast DDS looks for it in its working directory."""


class Middleware(NamedTuple):
    rmw: str
    variables: tuple[str, ...]
    prefix: str
    """Of the path in the value."""


CYCLONE = Middleware("rmw_cyclonedds_cpp", ("CYCLONEDDS_URI",), "file://")
FAST = Middleware("rmw_fastrtps_cpp", ("FASTRTPS_DEFAULT_PROFILES_FILE", "FASTDDS_DEFAULT_PROFILES_FILE"), "")
NAMES = ((regex(r"(?i)[^/]*cyclone[^/]*\.xml$"), CYCLONE), (regex(r"(?i)[^/]*fast_?(?:dds|rtps)[^/]*\.xml$"), FAST))
VARIABLES = (*CYCLONE.variables, *FAST.variables)


class Mount(NamedTuple):
    service: Service
    target: Located
    where: Located
    middleware: Middleware


@rule("warning", confidence="medium", silent="the nodes start with the defaults")
def dds_file_unused(robot: Robot) -> Iterator[Finding]:
    mounts = [mount for service in robot.compose.whole_services for mount in _mounts(service)]
    named = {str(mount.target): value for mount in mounts if (value := _names(robot, mount)) is not None}
    speaking = _speaking(robot, mounts[0].service.source) if mounts else set()
    exported = _exported(robot) if mounts else []
    for mount in mounts:
        if _may_be_set(robot, mount):
            continue
        other = named.get(str(mount.target))
        if (other is not None and not _is_exported(exported, mount)) or _is_unset_in_image(robot, mount, speaking):
            variable = mount.middleware.variables[0]
            yield finding(
                mount.where,
                f"Nothing in the container sets {variable}: '{mount.service.name}' runs with the defaults and does not "
                "read this file",
                advice=f"set {variable}: {mount.middleware.prefix}{mount.target}",
                related=[note(other, "another service names the file")] if other is not None else [],
            )


def _mounts(service: Service) -> Iterator[Mount]:
    for volume in service.volumes:
        path = volume.target or ""
        middleware = next((each for pattern, each in NAMES if pattern.search(path)), None)
        if middleware is not None and volume.target is not None and volume.source is not None:
            if not OF_ITSELF.search(path):
                yield Mount(service, volume.target, volume.where, middleware)


def _names(robot: Robot, mount: Mount) -> Located | None:
    """The value by which the service names the file."""
    values = (value for _, value in robot.compose.variables(mount.service, *mount.middleware.variables))
    return next((value for value in values if mount.target in value), None)


def _may_be_set(robot: Robot, mount: Mount) -> bool:
    """Whether the service may name the file, or not run the middleware that reads it."""
    service, middleware = mount.service, mount.middleware
    rmw = [value for _, value in robot.compose.variables(service, "RMW_IMPLEMENTATION")]
    if (middleware is CYCLONE or rmw) and middleware.rmw not in rmw:
        return True
    if any(name in service.environment for name in middleware.variables) or robot.compose.variables(
        service, *middleware.variables
    ):
        return True
    if len(robot.compose.env_files(service)) < len(service.env_files):
        return True
    words = (*middleware.variables, mount.target.rpartition("/")[2])
    if any(word in text for text in service.scripts for word in words):
        return True
    stage = robot.compose.stage(service)
    return stage is not None and any(name in middleware.variables for name, _ in environment_of(stage))


def _exported(robot: Robot) -> list[tuple[str, str]]:
    """The scripts and launch files that speak of a variable, each with that."""
    of_services = {each.absolute for one in robot.compose.services for each in robot.compose.env_files(one)}
    launched = ((each.absolute, each.text) for each in robot.sources if each.kind.startswith("launch-"))
    paths = (each for each in robot.tree.like(SHELLS) if each not in of_services and not each.endswith("/.env"))
    texts = (*launched, *((path, robot.tree.head(path, READ)) for path in paths))
    return [(path, name) for path, text in texts for name in VARIABLES if name in text]


def _is_exported(exported: list[tuple[str, str]], mount: Mount) -> bool:
    """Whether a script or a launch file that the container may start sets the variable: one of the folder of the
    compose file, or one that it names."""
    compose = mount.service.source
    folder = f"{posixpath.dirname(compose.absolute)}/"
    near = (name for path, name in exported if path.startswith(folder) or posixpath.basename(path) in compose.text)
    return any(name in mount.middleware.variables for name in near)


def _speaking(robot: Robot, compose: Source) -> set[tuple[str, str]]:
    """The folders of files that may get into an image and speak of a variable, with that."""
    top = compose.absolute[: -len(compose.name)]
    texts = ((each.name, each.text) for each in robot.sources if each.kind != "compose")
    told = ((path.removeprefix(top), robot.tree.head(path, READ)) for path in robot.tree.like(SHELLS))
    both = (each for all_of in (texts, told) for each in all_of)
    return {(posixpath.dirname(path), name) for path, text in both for name in VARIABLES if name in text}


def _is_unset_in_image(robot: Robot, mount: Mount, speaking: set[tuple[str, str]]) -> bool:
    """Whether the tree builds the image, and nothing that may get into it speaks of the variable."""
    stage = robot.compose.stage(mount.service)
    if stage is None or not mount.service.is_ros:
        return False
    beside = posixpath.dirname(mount.service.source.name)
    build = mount.service.build
    context = posixpath.normpath(posixpath.join(beside, str(build.context or "."))) if build is not None else beside
    folders = [beside, context, *(posixpath.dirname(one.start.keyword.span.source.name) for one in stage.chain)]
    near = (name for path, name in speaking if any(_is_in(each, f"{path}/") for each in folders))
    return not any(name in mount.middleware.variables for name in near)


def _is_in(folder: str, path: str) -> bool:
    return folder in ("", ".") or folder.startswith("..") or path.startswith(f"{folder}/")
