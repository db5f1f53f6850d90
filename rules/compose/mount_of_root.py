"""A container writes to a folder that docker makes for root, and runs as another user.

## What it finds
In a service that runs as another user than root:
- a bind mount of a folder that is not in the tree, whose name says that the container writes to it (`logs`, `bags`,
  `recordings`, `data`, `output`, `build` and the like);
- a named volume at a path that no step of its Dockerfile makes, on an official image.

Silent where a script, a recipe or a text for people makes the folder, where a script or the command calls `chown`,
where the folder is mounted read-only, below `/tmp`, and for a volume with options or one that several images mount.

## Why it matters on a robot
When the folder of a bind mount is missing, the docker daemon makes it, as root with mode 755. So it does with the
folder of a new volume, unless the image has one at that path: then the volume gets its owner. The process in the
container is not root: its logs, bags or builds end with "Permission denied" on each new robot.

## Bad
```yaml
user: "1000"
volumes:
  - ./recordings:/recordings   # not in the repository
```

## Good
```yaml
user: "1000"
volumes:
  - ./recordings:/recordings   # recordings/.gitkeep is in the repository
```

## When to ignore it
When the folder is made by hand before the first start.

## References
- https://docs.docker.com/engine/storage/bind-mounts/
- https://github.com/moby/moby/issues/2259
"""

import posixpath
import re
from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Located
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import note
from bringup_lint.api import regex
from bringup_lint.api import rule
from bringup_lint.api.compose import Service
from bringup_lint.api.compose import Volume
from bringup_lint.api.docker import expanded
from bringup_lint.api.docker import last_user
from bringup_lint.api.docker import runs_as_root

WRITTEN = regex(
    r"(?i)(?:.*[_.-])?(?:logs?|(?:ros)?bags?|rec|records?|recordings?|data|out|outputs?|results?|build|install|cache|ccache"
    r"|captures?|snapshots?|rosbag2?|ros_logs?|databases?|db|videos?|images)"
)
USER = regex(r"(?:\$\{\w+:?-)?(?P<name>[\w-]+)\}?(?::.*)?$")
CHOWN = regex(r"^[^#\n]*\b(?:chown|setfacl|fixuid|chmod\b[^\n]*\b0?777)\b[^\n]*", re.M)
TEXTS = regex(r"\.(?:md|rst|txt|sh|bash|ya?ml|mk)$|(?:^|/)(?:(?:GNU)?[Mm]akefile|[Jj]ustfile)$")
READ = 200_000
SCRIPTS = ("shell-script", "devcontainer")


VOLUME = regex(r"[A-Za-z0-9][\w.-]+")
MAKES = (
    r"\b(?:mkdir|install|chown|clone|cp|mv|tar|unzip|rsync|ln|touch|useradd|adduser|colcon|npm|yarn|pnpm|pip3?|uv|poetry)"
    r"\b[^\n]*(?:{path}|(?<![\w-]){name}(?![\w-]))"
)
OF_COLCON = ("build", "install", "log")


@rule("warning", confidence="medium", symptoms=["Permission denied: '*'"])
def mount_of_root(robot: Robot) -> Iterator[Finding]:
    for service in robot.compose.whole_services:
        user = _user(robot, service) if service.volumes else None
        if user is None:
            continue
        last = {str(each.target): each for each in service.volumes}
        for volume in last.values():
            if volume.where.span.start < service.body.span.start:
                continue
            is_bind = _is_for_writing(volume)
            if _is_missing(robot, service, volume) if is_bind else _is_new(robot, service, volume):
                what = volume.source if is_bind else f"the volume {volume.source}"
                yield finding(
                    volume.where,
                    f"docker makes {what} for root, and '{service.name}' runs as {_name(user)}: it cannot write there",
                    advice="keep the folder in the repository with a .gitkeep, or make it before the start"
                    if is_bind
                    else f"make {volume.target} in the Dockerfile, and give it to {_name(user)}",
                    related=[note(user, "the user")],
                )
                break


def _is_new(robot: Robot, service: Service, volume: Volume) -> bool:
    """Whether a named volume begins as an empty folder of root: nothing is at its path in the image."""
    stage = robot.compose.stage(service)
    if stage is None or volume.read_only or volume.target is None or not VOLUME.fullmatch(volume.source or ""):
        return False
    if not runs_as_root(stage.origin) or _is_shared(robot, service, volume) or _has_chown(robot, service, volume):
        return False
    path = str(volume.target).rstrip("/")
    if path.startswith("/tmp/"):
        return False
    name = posixpath.basename(path)
    steps = [each for one in stage.chain for each in one.all("RUN")]
    texts = "\n".join(text for each in steps for text in (str(each.value), *map(str, each.heredocs)))
    placed = (str(expanded(one, each)) for one in stage.chain for each in one.all("COPY", "ADD", "WORKDIR", "VOLUME"))
    if any(path in text or "$" in text for text in placed) or (name in OF_COLCON and "colcon" in texts):
        return False
    return re.search(MAKES.format(path=re.escape(path), name=re.escape(name)), texts) is None


def _is_shared(robot: Robot, service: Service, volume: Volume) -> bool:
    """Whether another image may make the folder, or the volume has options of its own."""
    own = robot.compose.stage(service)
    for other in robot.compose.services:
        if other.source is service.source and any(each.source == volume.source for each in other.volumes):
            is_same = other.image == service.image if other.build is None else robot.compose.stage(other) is own
            if not is_same:
                return True
    name = re.escape(str(volume.source))
    options = re.compile(rf"^[ \t]+{name}:[ \t]*\n(?:[ \t]+\S[^\n]*\n){{0,3}}?[ \t]+(?:driver_opts|external):", re.M)
    return options.search(service.source.text) is not None


def _has_chown(robot: Robot, service: Service, volume: Volume) -> bool:
    """Whether a script of the image, or one that names the folder, gives it to somebody."""
    names = {posixpath.basename(posixpath.normpath(str(each))) for each in (volume.source, volume.target) if each}
    found = ((each, match[0]) for each in robot.of_kind(*SCRIPTS) for match in CHOWN.finditer(each.text))
    if any(any(name in line for name in names) or robot.scripts.is_for_image(each) for each, line in found):
        return True
    return any(CHOWN.search(text) for text in service.scripts)


def _is_for_writing(volume: Volume) -> bool:
    path = volume.source or ""
    if volume.read_only or not path.startswith(("./", "../")) or "$" in path:
        return False
    return WRITTEN.fullmatch(posixpath.basename(posixpath.normpath(path)).removeprefix(".")) is not None


def _user(robot: Robot, service: Service) -> Located | None:
    """The user of the container, where it is certainly not root."""
    stage = robot.compose.stage(service)
    user = service.user or (last_user(stage) if stage is not None else None)
    return user if user is not None and _name(user) not in ("", "0", "root") else None


def _name(user: Located) -> str:
    match = USER.match(user)
    return match["name"] if match is not None else ""


def _is_missing(robot: Robot, service: Service, volume: Volume) -> bool:
    beside = posixpath.dirname(service.source.absolute)
    path = posixpath.normpath(posixpath.join(beside, str(volume.source)))
    if not robot.tree.holds(path) or robot.tree.exists(path):
        return False
    if _has_chown(robot, service, volume):
        return False
    name = re.escape(posixpath.basename(path))
    made = re.compile(rf"\bmkdir\b[^\n]*[\s/\"'{{,]{name}\b|\b(?:path|dest):[^\n]*/{name}\b|\bmakedirs\b[^\n]*{name}")
    return not any(made.search(robot.tree.head(each, READ)) for each in robot.tree.like(TEXTS))
