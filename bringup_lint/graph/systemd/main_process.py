"""The main process of a service: the one that systemd supervises, signals with KillMode=mixed and listens to.

A shell is replaced by what it execs; ``bash -c`` also execs the last command of its text by itself (bash
5.1 and later). dash and script files do not: there the shell stays, and what it starts are children.
"""

from __future__ import annotations

import re
from typing import TYPE_CHECKING
from typing import NamedTuple

from bringup_lint.graph.commands.command_line import SHELLS
from bringup_lint.graph.commands.following import SCRIPT_DEPTH
from bringup_lint.graph.commands.following import SHELL_SCRIPT
from bringup_lint.graph.commands.ros_command import Ros
from bringup_lint.graph.commands.ros_command import ros_command
from bringup_lint.graph.commands.wrappers import unwrapped
from bringup_lint.graph.systemd.process import Process
from bringup_lint.model.shell import Command
from bringup_lint.parsers.shell import commands
from bringup_lint.source import Located
from bringup_lint.source import Source

if TYPE_CHECKING:
    from bringup_lint.robot import Robot

CONTAINERS = frozenset(
    {"docker", "podman", "docker-compose", "podman-compose", "systemd-nspawn", "lxc-start", "lxc", "nerdctl"}
)
_PYTHON = re.compile(r"python[0-9.]*$")
_PYTHON_SCRIPT = re.compile(r"#!\s*\S*/(?:env\s+(?:-S\s+)?)?python")
_BUILTINS = frozenset(
    (
        ": . [ [[ alias break cd continue declare echo eval exit export false hash kill let local printf "
        "pwd read return set shift source test trap true type ulimit umask unset wait"
    ).split()
)
"""Commands that bash runs itself, so that there is nothing to exec."""
_TRAPS = re.compile(r"\btrap\b")


class Main(NamedTuple):
    """What the main process turns out to be."""

    kind: str
    """``launch``, ``run``, ``node``, ``cli`` (ROS 2 programs); ``shell`` (one that stays, with children);
    ``lost`` (a shell that runs a script which the tree does not hold); ``python`` (a script of the tree or
    not); ``container``; ``program`` (any other program); ``unknown``."""
    where: Located
    """The words that say so: the program, or the script that is run."""
    ros: Ros | None = None
    script: Source | None = None
    """The script of the tree that the process reads, if any."""

    @property
    def is_ros_tool(self) -> bool:
        """ros2 launch and ros2 run: the nodes are children of it."""
        return self.kind in ("launch", "run")


def main_process(process: Process, robot: Robot) -> Main:
    """The process that systemd takes for the main one, for Type= other than forking."""
    return _main(Command(process.argv), robot, 0, None)


def _main(command: Command, robot: Robot, depth: int, script: Source | None) -> Main:
    words = unwrapped(command.words)
    if not words or depth > SCRIPT_DEPTH:
        return Main("unknown", command.words[-1])
    name = words[0].rpartition("/")[2]
    if name in CONTAINERS:
        return Main("container", words[0])
    found = ros_command(command)
    if found is not None:
        return Main(found.kind, found.where, found, script)
    if name in SHELLS:
        return _shell(name, words, robot, depth)
    if _PYTHON.match(name):
        path = next((word for word in words[1:] if not word.startswith("-")), words[0])
        return Main("python", path, None, robot.find(path, path.span.source) if path.startswith("/") else None)
    if "/" in words[0] and "$" not in words[0] and "%" not in words[0]:
        return _program(words, robot, depth)
    return Main("unknown" if "$" in words[0] else "program", words[0])


def _program(words: tuple[Located, ...], robot: Robot, depth: int) -> Main:
    source = robot.find(words[0], words[0].span.source)
    shebang = SHELL_SCRIPT.match(source.text) if source else None
    if shebang:
        return _script(source, words, robot, depth)
    if source and _PYTHON_SCRIPT.match(source.text):
        return Main("python", words[0], None, source)
    if source is None and words[0].endswith((".sh", ".bash")):
        return Main("lost", words[0])
    return Main("program", words[0])


def _shell(name: str, words: tuple[Located, ...], robot: Robot, depth: int) -> Main:
    for at, word in enumerate(words[1:], 1):
        if word.startswith("-") and not word.startswith("--") and "c" in word and at + 1 < len(words):
            return _text(words[at + 1], words[0], (), robot, depth, None, implicit=name == "bash")
        if not word.startswith(("-", "+")):
            source = robot.find(word, word.span.source) if word.startswith("/") and "$" not in word else None
            return Main("lost", word) if source is None else _script(source, words[at:], robot, depth)
    return Main("shell", words[0])


def _script(source: Source, words: tuple[Located, ...], robot: Robot, depth: int) -> Main:
    text = source.located(0, len(source.text))
    return _text(text, words[0], words[1:], robot, depth, source, implicit=False)


def _text(
    text: Located,
    shell: Located,
    arguments: tuple[Located, ...],
    robot: Robot,
    depth: int,
    script: Source | None,
    *,
    implicit: bool,
) -> Main:
    """What becomes of a shell that reads ``text``."""
    found = [command for command in commands(text) if command.words]
    execs = [command for command in found if command.words[0] == "exec" and len(command.words) > 1]
    taken = next((command for command in execs if not command.depth), None)
    if taken is None and execs:
        return Main("unknown", shell)
    if taken is None and implicit and found and not _TRAPS.search(text):
        last, piped = found[-1], len(found) > 1 and found[-2].ends == "|"
        stays = last.depth or last.background or piped or last.name in _BUILTINS
        taken = None if stays else last
    if taken is None:
        return Main("shell", shell, None, script)
    words = taken.words
    if any(word in ("$@", "$*") for word in words):
        words = tuple(other for word in words for other in (arguments if word in ("$@", "$*") else (word,)))
        if len(words) < 2:
            return Main("unknown", shell)
    return _main(Command(words), robot, depth + 1, script)
