"""A script works only for one user, whose home it names.

## What it finds
`/home/NAME/FOLDER/...` in a script, where another place of the tree has the same folder in the home of whoever works
with it: `~/FOLDER` or `$HOME/FOLDER`. Silent for the users that images of boards have (`ubuntu`, `pi` and the like),
that the tree makes, becomes or logs in as, that its units run as, for the folders in which a page has people work, for
folders of containers and other computers, and where the script asks whether the path is there. It is info where nothing
of the tree names a script with such a path: it may be for its author alone.

## Why it matters on a robot
The script is right for the account of its author. On a robot with another user, "No such file or directory": the setup
file is not sourced, the profile of the middleware is not read, and the nodes start without it or not at all.

## Bad
```sh
cd ~/rover_ws
source /home/alice/rover_ws/install/setup.bash
```

## Good
```sh
cd ~/rover_ws
source ~/rover_ws/install/setup.bash
```

## When to ignore it
When all robots have a user of this name.

## References
- bash(1), "Tilde Expansion"
"""

import re
from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Located
from bringup_lint.api import Robot
from bringup_lint.api import Source
from bringup_lint.api import finding
from bringup_lint.api import note
from bringup_lint.api import regex
from bringup_lint.api import rule
from bringup_lint.api.docker import CONTAINER_KINDS
from bringup_lint.api.docker import container_folders
from bringup_lint.api.docker import is_in_container
from bringup_lint.api.docker import own_homes

PATH = regex(r"(?<![\w$}.~:/-])/home/(?P<user>[a-z][\w-]*)/(?P<folder>\w[\w.-]{2,})[\w./-]*", hints="/home/")
OF_BOARDS = regex(
    r"ubuntu|pi|debian|dietpi|orangepi|radxa|rock|nvidia|jetson|unitree|xilinx|deck|odroid|root|(?:your)?_?user(?:name)?|me"
)
ELSEWHERE = regex(
    r"#|\b(?:ssh|scp|rsync|docker|podman|distrobox)\b|\[[ \t]{1,4}(?:![ \t]{1,4})?-[defrsx][ \t]|\btest[ \t]{1,4}-"
    r"|\bfor[ \t]{1,4}\w+[ \t]{1,4}in[ \t]"
)
"""Before the path on its line: a comment, another computer or a container, the question whether it is there, or
several to choose from."""
OF_EVERYBODY = regex(
    r"(?<![\w/])(?:~|\$HOME|\$\{HOME\}|/home/\$\{?USER\}?)/(?P<folder>[\w.-]{1,255})(?![\w-])", hints="~ $"
)
PAGES = regex(r"\.(?:md|rst|txt|sh|bash|service)$|akefile$")
MOST = 200_000
FEW = 20
"""Users that are authors; of more, a tree makes the homes itself."""


@rule("warning", symptoms=["cd: /home/*: No such file or directory"])
def home_of_one_user(robot: Robot) -> Iterator[Finding]:
    named: dict[tuple[str, str], list[Located]] = {}
    for source in robot.of_kind("shell-script"):
        if source.judged and not source.template and robot.purpose(source).value == "robot":
            for path, user, folder in _named(source):
                named.setdefault((user, folder), []).append(path)
    known = (*container_folders(robot.of_kind(*CONTAINER_KINDS)), *own_homes(robot)) if named else ()
    places = _of_everybody(robot, {folder for _, folder in named}) if named else {}
    written = {user for user, folder in named if folder in places}
    users = {user for user in written if len(written) > FEW or _is_of_robot(robot, user)}
    for (user, folder), paths in named.items():
        left = [path for path in paths if not is_in_container(path, known)]
        place = places.get(folder) if left and user not in users else None
        if place is not None:
            yield finding(
                left[0],
                f"Only {user} has this folder: for every other user it is ~/{folder}, as it is called elsewhere",
                advice=f"write $HOME/{folder}",
                related=[
                    note(place, "the folder of whoever works with it"),
                    *(note(other, "and here") for other in left[1:20]),
                ],
                severity=None if any(robot.scripts.is_named(path.span.source) for path in left) else "info",
            )


def _named(source: Source) -> Iterator[tuple[Located, str, str]]:
    """The paths in homes of a script, with the user and the first folder."""
    for match in PATH.finditer(source.said):
        if not OF_BOARDS.fullmatch(match["user"]) and not ELSEWHERE.search(source.line_before(match.start())):
            yield source.located(*match.span()), match["user"], match["folder"]


def _is_of_robot(robot: Robot, user: str) -> bool:
    """Whether a text of the tree makes the user, becomes the user, or logs in so."""
    name = rf"(?<![\w/.-]){re.escape(user)}"
    used = re.compile(
        rf"\b(?:ssh|scp|sftp|rsync)\b[^\n]{{0,120}}{name}@"
        rf"|\b(?:su|sudo|runuser|useradd|adduser|usermod|chown|passwd)\b[^\n]{{0,60}}{name}(?![\w/@])"
        rf"|\b[Uu]ser(?:name)?\b[\s`\"'*:=]{{1,6}}(?:(?:is|called|named)\b[\s`\"':]{{1,4}}){{0,2}}{name}(?![\w/@])"
    )
    return any(user in text and used.search(text) for text in robot.tree.pages(PAGES, MOST))


def _of_everybody(robot: Robot, folders: set[str]) -> dict[str, Located]:
    """For each of some folders the first place that has it in the home of whoever reads or runs it."""
    found: dict[str, tuple[str, int, int]] = {}
    for path in robot.tree.like(PAGES):
        for match in OF_EVERYBODY.finditer(robot.tree.head(path, MOST)):
            name = next(filter(folders.__contains__, _names(match["folder"])), None)
            if name is not None:
                found.setdefault(name, (path, match.start(), match.start("folder") + len(name)))
    sources = {path: robot.tree.read(path, judged=False) for path, _, _ in found.values()}
    placed = ((name, sources[path], start, end) for name, (path, start, end) in found.items())
    return {name: source.located(start, end) for name, source, start, end in placed if source is not None}


def _names(written: str) -> Iterator[str]:
    """A name, and what is left of it before each dot, which may be that of a sentence."""
    yield written
    yield from (written[:at] for at, letter in enumerate(written) if letter == ".")
