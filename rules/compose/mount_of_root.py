"""A container writes to a folder that docker makes for root, and runs as another user.

## What it finds
A bind mount of a folder that is not in the tree, whose name says that the container writes to it (`logs`, `bags`,
`recordings`, `data`, `output`, `build` and the like), where the service or its image runs as another user than root.
Silent where a script, a recipe or a text for people makes the folder, where a script calls `chown`, and where the
folder is mounted read-only.

## Why it matters on a robot
When the folder of a bind mount is missing, the docker daemon makes it, as root with mode 755. The process in the
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
from bringup_lint.api.docker import last_user

WRITTEN = regex(
    r"(?i)(?:.*[_.-])?(?:logs?|(?:ros)?bags?|rec|records?|recordings?|data|out|outputs?|results?|build|install|cache|ccache"
    r"|captures?|snapshots?|rosbag2?|ros_logs?|databases?|db|videos?|images)"
)
USER = regex(r"(?:\$\{\w+:?-)?(?P<name>[\w-]+)\}?(?::.*)?$")
CHOWN = regex(r"^[^#\n]*\b(?:chown|chmod|setfacl|gosu|su-exec|setpriv|fixuid)\b", re.M)
TEXTS = regex(r"\.(?:md|rst|txt|sh|bash|ya?ml|mk)$|(?:^|/)(?:(?:GNU)?[Mm]akefile|[Jj]ustfile)$")
READ = 200_000


@rule("warning", confidence="medium", symptoms=["Permission denied: '*'"])
def mount_of_root(robot: Robot) -> Iterator[Finding]:
    for service in robot.compose.whole_services:
        mounts = [each for each in service.volumes if _is_for_writing(each)]
        user = _user(robot, service) if mounts else None
        if user is None:
            continue
        for volume in mounts:
            if _is_missing(robot, service, volume):
                yield finding(
                    volume.where,
                    f"docker makes {volume.source} for root, and '{service.name}' runs as {_name(user)}: it cannot "
                    "write there",
                    advice="keep the folder in the repository with a .gitkeep, or make it before the start",
                    related=[note(user, "the user")],
                )
                break


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
    below = posixpath.dirname(service.source.name)
    scripts = (each for each in robot.of_kind("shell-script") if not below or each.name.startswith(f"{below}/"))
    if any(CHOWN.search(each.text) for each in scripts):
        return False
    name = re.escape(posixpath.basename(path))
    made = re.compile(rf"\bmkdir\b[^\n]*[\s/\"'{{,]{name}\b|\b(?:path|dest):[^\n]*/{name}\b|\bmakedirs\b[^\n]*{name}")
    return not any(made.search(robot.tree.head(each, READ)) for each in robot.tree.like(TEXTS))
