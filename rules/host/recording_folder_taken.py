"""A recording that starts by itself always writes to the same folder.

## What it finds
`ros2 bag record -o FOLDER` in a unit, a container or a cron job, or in a script that one of these starts, with a folder
that is the same at every start. In a container it has to be on a volume, or the container has a restart policy.

Not reported: folders below `/tmp` and `/run`, and those that something of the tree deletes or moves.

## Why it matters on a robot
rosbag2 does not write into a folder that is there: it prints "Output folder already exists" and ends. The first start
records, and after the next boot, or the first crash, nothing is recorded any more.

## Bad
```sh
ros2 bag record -o /srv/bags/survey /odom /scan
```

## Good
```sh
ros2 bag record -o "/srv/bags/survey-$(date +%Y%m%d-%H%M%S)" /odom /scan
```

## When to ignore it
When something outside of the tree moves the recordings away before the next start.

## References
- https://github.com/ros2/rosbag2, ros2bag/verb/record.py
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
from bringup_lint.api.docker import Runner
from bringup_lint.api.docker import recordings

OPTIONS = ("-o", "--output")
FIXED = regex(r"(?!/tmp/|/run/|/dev/)[~\w./-]*[\w-]")
PROGRAM = regex(r"\.(?:sh|bash|py)$")
MOST = 100_000
"""Characters of a program that are looked at."""
MOVES = regex(r"\b(?:cd|pushd)[ \t]+[^\n;&|]{0,200}[$`]")
"""A relative folder is in another one each time."""
DELETES = r"(?:\b(?:rm|mv|rmtree|unlink|rename|move)|-delete)\b"


@rule("warning", confidence="medium", symptoms=["Output folder '*' already exists."])
def recording_folder_taken(robot: Robot) -> Iterator[Finding]:
    if not robot.may_hold("bag"):
        return
    seen = set()
    for runner, words in recordings(robot.runners.all):
        folder = _folder(words)
        if folder is None or folder.span in seen or not _stays(runner, folder):
            continue
        seen.add(folder.span)
        if not _is_cleared(robot, folder):
            yield finding(
                folder,
                f"{runner.name} records to {folder} at every start: the second time, it exists, and ros2 bag ends",
                advice=f"put the time into the name: {folder}-$(date +%Y%m%d-%H%M%S)",
                related=[note(runner.where, f"{runner.name} starts it")],
            )


def _folder(words: Sequence[Located]) -> Located | None:
    """The folder that a recording is told to make, when it is always the same."""
    named = next((word for before, word in pairwise(words) if before in OPTIONS), None)
    if named is None or not FIXED.fullmatch(named):
        return None
    is_relative = not named.startswith(("/", "~"))
    return None if is_relative and MOVES.search(named.span.source.text) else named


def _stays(runner: Runner, folder: str) -> bool:
    """Whether the folder is still there at the next start."""
    if runner.service is None:
        return True
    if runner.service.get("tmpfs") is not None:
        return False
    below = [str(volume.target) for volume in runner.service.volumes]
    return bool(runner.restarts) or any(posixpath.join(folder, "").startswith(f"{each.rstrip('/')}/") for each in below)


def _is_cleared(robot: Robot, folder: Located) -> bool:
    """Whether something deletes or moves the folder, or a program that names it may."""
    name = re.escape(posixpath.basename(folder))
    above = re.escape(posixpath.dirname(folder)) if folder.count("/") > 1 else name
    deletes = rf"{DELETES}[^\n]{{0,200}}(?:{name}|{above}/?[*\"']*(?:\s|$))"
    if robot.mentions(re.compile(rf"{deletes}|(?:{name}|{above}\b)[^\n]{{0,200}}{DELETES}")):
        return True
    programs = robot.tree.pages(PROGRAM, MOST)
    texts = (text for text in programs if str(folder) in text or f"{posixpath.dirname(folder)}/*" in text)
    own = folder.span.source.text
    return any(text != own and re.search(DELETES, text) for text in texts)
