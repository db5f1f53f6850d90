"""A script turns off the access control of the X server.

## What it finds
`xhost +` without a name, also where `xhost -` of the same script turns it on again later. `xhost +local:` and
`xhost +si:localuser:root` let in whom they name and are not reported.

`chmod 777`, `chmod 666` and the like on a copy of the X server's authority file, such as `/tmp/.docker.xauth`; an info
where the mode only lets everybody read it. Silent where xauth writes the file after that: it makes a new one, with mode
600.

## Why it matters on a robot
It stays off until the user logs out, or until the program between the two has ended. Every user, program and
container that reaches the display can read its keyboard and screen and type into its windows: the terminal in which the
robot is driven, with its sudo. Where the X server listens to the network, every other computer can too.

## Bad
```sh
xhost +
docker run -e DISPLAY -v /tmp/.X11-unix:/tmp/.X11-unix mower/rviz
```

## Good
```sh
xhost +si:localuser:root
docker run -e DISPLAY -v /tmp/.X11-unix:/tmp/.X11-unix mower/rviz
```

## When to ignore it
When nobody but the operator has an account, a container or a cable to this computer.

## References
- xhost(1)
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Located
from bringup_lint.api import Robot
from bringup_lint.api import Source
from bringup_lint.api import finding
from bringup_lint.api import note
from bringup_lint.api import regex
from bringup_lint.api import rule
from bringup_lint.api.shell import Run

COOKIE = regex(r"(?:.*/)?[\w.-]*(?:[xX]auth|Xauthority)[\w.-]*")
WRITABLE = regex(r"0?[0-7]{0,2}[2367]|[ugo]*[ao][ugo]*[+=]\w*w\w*|\+\w*w\w*")
READABLE = regex(r"0?[0-7]{0,2}[4567]|[ugo]*[ao][ugo]*[+=]\w*r\w*|\+\w*r\w*")

WRITES = frozenset({"merge", "nmerge", "add", "generate", "remove"})
"""Commands of xauth that change the file."""


@rule("warning", silent="xhost says that anyone can connect, which is what was asked for")
def display_open(robot: Robot) -> Iterator[Finding]:
    opened: dict[Source, list[Located]] = {}
    closed: dict[Source, Located] = {}
    for source, run in robot.scripts.run("xhost"):
        if run.words[1:] == ("+",):
            opened.setdefault(source, []).append(run.words[1])
        elif run.words[1:] == ("-",):
            closed[source] = run.words[1]
    for source, (first, *others) in opened.items():
        until = [note(closed[source], "until here")] if source in closed else []
        yield finding(
            first,
            "xhost + lets every user and container that reaches this display read its keyboard and type into it",
            advice="name who needs it, for example xhost +si:localuser:root for a container",
            related=[*until, *(note(other, "here too") for other in others)],
        )
    written = _written(robot)
    for source, run in robot.scripts.run("chmod"):
        yield from _of_mode(source, run, written)


def _written(robot: Robot) -> dict[tuple[Source, str], int]:
    """Where a script writes a file with xauth for the last time."""
    found: dict[tuple[Source, str], int] = {}
    for source, run in robot.scripts.run("xauth"):
        if not WRITES.isdisjoint(run.words):
            found.update(((source, run.text(word)), word.span.start) for word in run.words[1:])
    return found


def _of_mode(source: Source, run: Run, written: dict[tuple[Source, str], int]) -> Iterator[Finding]:
    words = [word for word in run.words[1:] if not word.startswith("--")]
    if len(words) > 1 and (WRITABLE.fullmatch(words[0]) or READABLE.fullmatch(words[0])):
        for word in words[1:]:
            path = run.text(word)
            if COOKIE.fullmatch(path) and written.get((source, path), 0) < word.span.start:
                yield finding(
                    word,
                    f"chmod {words[0]} gives every user of this computer the key to the screen and the keyboard",
                    advice="leave mode 600, and let the container run as the user who owns the file",
                    severity=None if WRITABLE.fullmatch(words[0]) else "info",
                )
