"""A container writes to a folder that docker makes for root, and runs as another user.

## What it finds
In a service that runs as another user than root:
- a bind mount of a folder that is not in the tree, whose name says that the container writes to it (`logs`, `bags`,
  `recordings`, `data`, `output`, `build` and the like);
- a named volume at a path that no step of its Dockerfile makes, on an official image.

Silent where a script, a recipe or a text for people makes the folder or names a file in it, where a script or a command
calls `chown`, where the folder is mounted read-only, below `/tmp`, and for a volume with options or one that several
images mount.

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
from collections import Counter
from collections.abc import Iterator
from functools import cached_property

from bringup_lint.api import Finding
from bringup_lint.api import Located
from bringup_lint.api import Robot
from bringup_lint.api import Source
from bringup_lint.api import finding
from bringup_lint.api import note
from bringup_lint.api import regex
from bringup_lint.api import rule
from bringup_lint.api.compose import Service
from bringup_lint.api.compose import Volume
from bringup_lint.api.docker import Stage
from bringup_lint.api.docker import expanded
from bringup_lint.api.docker import last_user
from bringup_lint.api.docker import runs_as_root

WRITTEN = regex(
    r"(?i)(?:.*[_.-])?(?:logs?|(?:ros)?bags?|rec|records?|recordings?|data|out|outputs?|results?|build|install|cache|ccache"
    r"|captures?|snapshots?|rosbag2?|ros_logs?|databases?|db|videos?|images)"
)
USER = regex(r"(?:\$\{\w+:?-)?(?P<name>[\w-]+)\}?(?::.*)?$")
CHOWN = regex(r"^[^#\n]*\b(?:chown|setfacl|fixuid|chmod\b(?:(?!\bchmod\b)[^\n])*\b0?777)\b[^\n]*", re.M)
TEXTS = regex(r"\.(?:md|rst|txt|sh|bash|ya?ml|mk|py|service|conf)$|(?:^|/)(?:(?:GNU)?[Mm]akefile|[Jj]ustfile)$")
READ = 200_000
SCRIPTS = ("shell-script", "devcontainer")
PLACING = ("COPY", "ADD", "WORKDIR", "VOLUME")
MOST = 100
"""Volumes of an image that are looked for in its steps."""
VOLUME = regex(r"[A-Za-z0-9][\w.-]+")
MAKES = regex(
    r"\b(?:mkdir|install|chown|clone|cp|mv|tar|unzip|rsync|ln|touch|useradd|adduser|colcon|npm|yarn|pnpm|pip3?|uv|poetry)\b"
)
OF_COLCON = ("build", "install", "log")
MAKING = regex(
    r"^[^\n]*(?:\bmkdir\b|\bmakedirs\b|\binstall[ \t]+-d\b|\b(?:path|dest):)[^\n]*"
    r"|^[ \t]*for[ \t]+\w+[ \t]+in[ \t][^\n]*"
    r"|^[dDvqQ]\+?[ \t]+/[^\n]*",
    re.M,
)
"""Lines that make folders, a loop over names of some among them."""
FILLED = regex(r"(?<![\w/.-])(?:\./)?(?P<folder>[\w-]+)/[\w-]+\.\w")
"""A file that somebody puts into a folder."""
WORD = regex(r"[\w.-]+")
OPTIONS = regex(
    r"^[ \t]+(?P<name>[\w.-]+):[ \t]*$(?=\n(?:[ \t]+\S[^\n]*\n){0,3}?[ \t]+(?:driver_opts|external):)",
    re.M,
    "driver_opts external",
)
"""Volumes that are not only a folder of docker."""


class Known:
    """What the tree says of folders, each asked once."""

    def __init__(self, robot: Robot) -> None:
        self._robot = robot
        self._steps: dict[Stage, tuple[str, str]] = {}
        self.left: Counter[Stage] = Counter()

    @cached_property
    def given(self) -> frozenset[str]:
        """The words of the lines of scripts that give something to somebody."""
        lines = (line for source in self._robot.of_kind(*SCRIPTS) for line in CHOWN.findall(source.text))
        return frozenset(word for line in lines for word in WORD.findall(line))

    @cached_property
    def openers(self) -> list[str]:
        """The scripts of images that give something to somebody."""
        scripts = (each for each in self._robot.of_kind(*SCRIPTS) if CHOWN.search(each.text))
        return [each.name for each in scripts if self._robot.scripts.is_for_image(each)][:MOST]

    @cached_property
    def made(self) -> frozenset[str]:
        """The words of the lines of scripts, recipes and texts that make folders."""
        texts = [self._robot.tree.head(path, READ) for path in self._robot.tree.like(TEXTS)]
        words = {word for text in texts for line in MAKING.findall(text) for word in WORD.findall(line)}
        return frozenset(words.union(*(FILLED.findall(text) for text in texts)))

    @cached_property
    def mounting(self) -> dict[tuple[Source, str], list[Service]]:
        """The services of a file that mount a volume."""
        found: dict[tuple[Source, str], list[Service]] = {}
        for service in self._robot.compose.services:
            for volume in service.volumes:
                found.setdefault((service.source, str(volume.source)), []).append(service)
        return found

    @cached_property
    def with_options(self) -> frozenset[tuple[Source, str]]:
        files = (file.source for file in self._robot.compose.files)
        return frozenset((each, match["name"]) for each in files for match in OPTIONS.finditer(each.text))

    def steps(self, stage: Stage) -> tuple[str, str]:
        """What the steps of an image run, and the places to which they copy."""
        if stage not in self._steps:
            runs = [each for one in stage.chain for each in one.all("RUN")]
            texts = "\n".join(text for each in runs for text in (str(each.value), *map(str, each.heredocs)))
            places = (str(expanded(one, each)) for one in stage.chain for each in one.all(*PLACING))
            self._steps[stage] = texts, "\n".join(places)
        return self._steps[stage]


@rule("warning", confidence="medium", symptoms=["Permission denied: '*'"])
def mount_of_root(robot: Robot) -> Iterator[Finding]:
    known = Known(robot)
    for service in robot.compose.whole_services:
        user = _user(robot, service) if service.volumes else None
        if user is None or any(CHOWN.search(text) for text in service.scripts):
            continue
        last = {str(each.target): each for each in service.volumes}
        for volume in last.values():
            if volume.where.span.start < service.body.span.start or _is_given(known, service, volume):
                continue
            is_bind = _is_for_writing(volume)
            if _is_missing(robot, service, volume, known) if is_bind else _is_new(robot, service, volume, known):
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


def _is_given(known: Known, service: Service, volume: Volume) -> bool:
    """Whether a script of an image beside it, or one that names the folder, gives it to somebody."""
    below = posixpath.dirname(service.source.name)
    paths = [str(each) for each in (volume.source, volume.target) if each]
    if any(posixpath.basename(posixpath.normpath(path)) in known.given for path in paths):
        return True
    if any(CHOWN.search(text) for each in known.mounting[service.source, str(volume.source)] for text in each.scripts):
        return True
    return any(not below or name.startswith(f"{below}/") for name in known.openers)


def _is_new(robot: Robot, service: Service, volume: Volume, known: Known) -> bool:
    """Whether a named volume begins as an empty folder of root: nothing is at its path in the image."""
    stage = robot.compose.stage(service)
    if stage is None or volume.read_only or volume.target is None or not VOLUME.fullmatch(volume.source or ""):
        return False
    path = str(volume.target).rstrip("/")
    if path.startswith("/tmp/") or not runs_as_root(stage.origin) or _is_shared(robot, service, volume, known):
        return False
    known.left[stage] += 1
    texts, places = known.steps(stage)
    name = posixpath.basename(path)
    if known.left[stage] > MOST or path in places or "$" in places or (name in OF_COLCON and "colcon" in texts):
        return False
    return not _is_made(path, name, texts)


def _is_made(path: str, name: str, texts: str) -> bool:
    """Whether a line of the steps of an image makes a folder."""
    place = re.compile(rf"{re.escape(path)}|(?<![\w-]){re.escape(name)}(?![\w-])")
    lines = ((line, MAKES.search(line)) for line in texts.split("\n") if name in line)
    return any(making is not None and place.search(line, making.end()) for line, making in lines)


def _is_shared(robot: Robot, service: Service, volume: Volume, known: Known) -> bool:
    """Whether another image may make the folder, or the volume has options of its own."""
    key = (service.source, str(volume.source))
    own = robot.compose.stage(service)
    others = known.mounting[key][:MOST]
    is_same = (
        each.image == service.image if each.build is None else robot.compose.stage(each) is own for each in others
    )
    return key in known.with_options or not all(is_same)


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


def _is_missing(robot: Robot, service: Service, volume: Volume, known: Known) -> bool:
    beside = posixpath.dirname(service.source.absolute)
    path = posixpath.normpath(posixpath.join(beside, str(volume.source)))
    if not robot.tree.holds(path) or robot.tree.exists(path):
        return False
    return posixpath.basename(path) not in known.made
