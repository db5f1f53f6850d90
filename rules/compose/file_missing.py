"""A compose file names a file or folder that does not exist.

## What it finds
Build contexts, Dockerfiles (the default one of a context, too), env files, bind-mounted configuration files and folders
that are mounted read-only, or for `config`, `launch`, `src` and the like, with a path relative to the compose file,
and bind-mounted files below `/tmp`, such as `/tmp/.docker.xauth`, of which no script and no document of the tree
speaks. In files of other names than compose.yaml and docker-compose.yml, services with neither image nor build belong
to another file. Files that git ignores, files of which the tree has a copy or a template, files that a shell script
names, keystores, and paths that exist below a folder above are not reported; mounts of the latter are, where nothing
of the tree sets the folder of a project. A mount is a warning, one that the container starts an error (a file of
nearly the same name beside the compose file is then meant rather than a copy elsewhere), a folder of which nothing
names a file is info, and so are the build of an image that may be pulled instead and a file that a page of the tree
tells people to make.

## Why it matters on a robot
docker compose ends with "path not found" or "env file not found" and starts none of the services. For a mount docker
makes an empty folder of that name, and the program in the container fails to read it.

## Bad
```yaml
services:
  drive:
    build: ./drvie
```

## Good
```yaml
services:
  drive:
    build: ./drive
```

## When to ignore it
When a step before the start puts the file there.

## References
- https://docs.docker.com/reference/compose-file/build/
- https://docs.docker.com/engine/storage/bind-mounts/
"""

import posixpath
import re
from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import regex
from bringup_lint.api import rule
from bringup_lint.api.compose import MissingFile
from bringup_lint.api.compose import missing_files
from bringup_lint.api.compose import nearly_named

PAGE = regex(r"\.(?:md|rst|txt|adoc)$", re.I)
MOST = 200_000
"""Characters of a page that are read."""
MADE = ("env_file", "mount", "mounted program")
MAKE = regex(
    r"(?:^|[.:;,$]|\b(?:and|then|please|to|must))[ \t]*(?:[-*+#>|]+[ \t]+|\d{1,2}[.)][ \t]+)?"
    r"(?:create|prepare|generate|write|download|touch)"
    r"(?:[ \t]+(?:an?|the|your|own|new|empty|executable|file|script|called|named)\b){0,6}"
    r"[ \t]+(?:[`'\"*_]{1,3})?(?P<name>[\w./-]*\w)",
    re.I | re.M,
    "create prepare generate write download touch",
)


@rule(
    "error",
    symptoms=[
        "env file",
        "unable to prepare context: path",
        "failed to read dockerfile",
        'invalid mount config for type "bind": bind source path does not exist:',
        "env file * not found",
        "not a directory: unknown: Are you trying to mount a directory onto a file",
        "is a directory: permission denied",
    ],
)
def file_missing(robot: Robot) -> Iterator[Finding]:
    found = list(missing_files(robot.files, robot.compose))
    to_make = _names_to_make(robot) if found else set()
    for missing in found:
        effect = "docker compose ends" if missing.fatal else "the image cannot be built here"
        if missing.what.startswith("mount"):
            effect = "docker mounts an empty folder in its place"
        if missing.what == "mounted program":
            effect += ", and cannot start it"
        lacks = "is made by nothing of this tree" if missing.path.startswith("/tmp/") else "does not exist"
        what = missing.what
        if what == "default Dockerfile":
            what, lacks = "build context", "holds no Dockerfile"
        yield finding(
            missing.path,
            f"The {what} '{missing.path}' of service '{missing.service.name}' {lacks}: {effect}",
            advice=_advice(robot, missing),
            severity="info" if missing.what in MADE and _name(missing) in to_make else _severity(robot, missing),
        )


def _name(missing: MissingFile) -> str:
    return posixpath.basename(missing.path)


def _names_to_make(robot: Robot) -> set[str]:
    """The names of files that pages tell whoever installs the robot to make."""
    told = (match["name"] for text in robot.tree.pages(PAGE, MOST) for match in MAKE.finditer(text))
    return {posixpath.basename(name) for name in told}


def _advice(robot: Robot, missing: MissingFile) -> str:
    if missing.what == "default Dockerfile":
        return "name the file with dockerfile:, relative to the context"
    if missing.path.startswith("/tmp/"):
        return "let a script or a unit make it before the start"
    near = nearly_named(robot.files, missing)
    if near:
        return f"write {' or '.join(near)}"
    return "put it there, or write the path of what is meant, relative to the folder of the compose file"


def _severity(robot: Robot, missing: MissingFile) -> str | None:
    if missing.fatal:
        return None
    if missing.what == "mounted folder" and not _is_read(robot, missing):
        return "info"
    return "warning" if missing.what.startswith("mount") else "info"


def _is_read(robot: Robot, missing: MissingFile) -> bool:
    """Whether something of the tree names a file below the folder in the container."""
    targets = [volume.target for volume in missing.service.volumes if volume.source is missing.path]
    return any(target and robot.mentions(re.compile(re.escape(f"{target.rstrip('/')}/"))) for target in targets)
