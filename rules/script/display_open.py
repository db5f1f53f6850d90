"""A script turns off the access control of the X server.

## What it finds
`xhost +` without a name, also where `xhost -` of the same script turns it on again later. `xhost +local:` and
`xhost +si:localuser:root` let in whom they name and are not reported.

`chmod 777`, `chmod 666` and the like on a copy of the X server's authority file, such as `/tmp/.docker.xauth`; an info
where the mode only lets everybody read it. Silent where xauth writes the file after that in the same branch of the
script, or outside of all branches: it makes a new one, with mode 600.

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

from collections.abc import Iterable
from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Located
from bringup_lint.api import Robot
from bringup_lint.api import Source
from bringup_lint.api import finding
from bringup_lint.api import note
from bringup_lint.api import regex
from bringup_lint.api import rule
from bringup_lint.api.shell import Block
from bringup_lint.api.shell import Command
from bringup_lint.api.shell import Run
from bringup_lint.api.shell import shell_blocks

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
    written = list(robot.scripts.run("xauth"))
    for source, run in robot.scripts.run("chmod"):
        yield from _of_mode(source, run, [each for script, each in written if script is source])


def _of_mode(source: Source, run: Run, written: list[Run]) -> Iterator[Finding]:
    words = [word for word in run.words[1:] if not word.startswith("--")]
    if len(words) > 1 and (WRITABLE.fullmatch(words[0]) or READABLE.fullmatch(words[0])):
        for word in words[1:]:
            path = run.text(word)
            if COOKIE.fullmatch(path) and not _is_written_after(source, run, _writing(path, written)):
                yield finding(
                    word,
                    f"chmod {words[0]} gives every user of this computer the key to the screen and the keyboard",
                    advice="leave mode 600, and let the container run as the user who owns the file",
                    severity=None if WRITABLE.fullmatch(words[0]) else "info",
                )


def _writing(path: str, written: list[Run]) -> set[int]:
    """Where the commands of xauth begin that write a file."""
    return {
        _start(run.command)
        for run in written
        if not WRITES.isdisjoint(run.words) and path in map(run.text, run.words[1:])
    }


def _is_written_after(source: Source, run: Run, writes: set[int]) -> bool:
    return bool(writes) and _follows(shell_blocks(source), _start(run.command), writes) is True


def _follows(body: Iterable[Block], start: int, writes: set[int]) -> bool | None:
    """Whether one of some commands surely runs after the one that starts at a place: further below in its body, or in
    one around it up to a function, which runs in an order of its own. None: the body does not have that one."""
    found: bool | None = None
    guarded = False
    for block in body:
        at = _start(block.command) if block.command is not None else -1
        if found is not None and at in writes and not guarded:
            return True
        inner = [_follows(each, start, writes) for each in (block.condition, *block.bodies)]
        if True in inner or (False in inner and block.kind == "function"):
            return True in inner
        if at == start or False in inner:
            found = False
        ends = block.command.ends if block.command is not None else block.ends
        guarded = ends == "||" or (ends == "&&" and at != start) or (ends == "|" and guarded)
    return found


def _start(command: Command) -> int:
    return command.words[0].span.start if command.words else -1
