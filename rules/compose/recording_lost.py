"""A container records to a place that does not outlive it.

## What it finds
A compose service that starts `ros2 bag record` by itself and writes to a folder below `tmpfs:`, or to one that no
volume covers. Silent where the folder is a variable, for services without a restart policy, and where a command
of the tree takes files out of containers (`docker cp`) or uploads them.

## Why it matters on a robot
What is written to a tmpfs takes the memory of the robot, and is gone when the container stops. The files of a container
itself are gone when it is made anew, as with each `docker compose up` after a change of its image or settings.

## Bad
```yaml
recorder:
  image: ros:jazzy
  restart: unless-stopped
  command: ros2 bag record -o /bags/run /odom /scan
```

## Good
```yaml
recorder:
  image: ros:jazzy
  restart: unless-stopped
  volumes: ["/srv/bags:/bags"]
  command: ros2 bag record -o /bags/run /odom /scan
```

## When to ignore it
When a node uploads the recordings before the container ends.

## References
- https://docs.docker.com/engine/storage/
- https://docs.docker.com/engine/storage/tmpfs/
"""

import posixpath
import re
from collections.abc import Iterator
from collections.abc import Sequence
from itertools import pairwise

from bringup_lint.api import Finding
from bringup_lint.api import Located
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import note
from bringup_lint.api import regex
from bringup_lint.api import rule
from bringup_lint.api.compose import Service
from bringup_lint.api.docker import recordings

OPTIONS = ("-o", "--output")
KNOWN = regex(r"/[\w./-]*[\w-]|(?P<folder>/[\w./-]*/)[^\s/$`]*[$`][^\n]*")
"""A folder, also one whose last name is made anew each time."""
TAKES = regex(r"\bdocker(?:-compose|[ \t]+compose)?[ \t]+cp\b|\bupload|\brclone\b|\brsync\b|\bs3\b", re.I)


@rule("warning", confidence="medium", silent="the recording works, and is gone with the container")
def recording_lost(robot: Robot) -> Iterator[Finding]:
    seen = set()
    for runner, words in recordings(robot.runners.all):
        service = runner.service
        folder = _folder(words)
        if service is None or folder is None or folder.span in seen or not runner.restarts:
            continue
        seen.add(folder.span)
        memory = _covers(service.tmpfs, folder)
        parts = robot.compose.services_called(service.name)
        if (memory or not any(_is_kept(each, folder) for each in parts)) and not robot.mentions(TAKES):
            yield finding(
                folder,
                f"'{service.name}' records to "
                + ("a tmpfs: it takes memory, and is gone" if memory else "the container itself: it is gone")
                + (" when the container stops" if memory else " when the container is made anew"),
                advice="mount a folder of the host there",
                related=[note(service.name, "no volume covers the folder")],
            )


def _folder(words: Sequence[Located]) -> Located | None:
    named = next((word for before, word in pairwise(words) if before in OPTIONS), None)
    return named if named is not None and KNOWN.fullmatch(named) else None


def _covers(targets: Sequence[str], folder: str) -> bool:
    return any(posixpath.join(folder, "").startswith(f"{str(each).rstrip('/')}/") for each in targets)


def _is_kept(service: Service, folder: str) -> bool:
    """Whether a volume may cover the folder."""
    if service.get("extends") is not None or service.get("volumes_from") is not None:
        return True
    targets = [str(each.target) for each in service.volumes if each.target is not None]
    return any("$" in each for each in targets) or _covers(targets, folder)
