"""The main process of a service: the one that systemd supervises, signals with KillMode=mixed and listens to.

A shell is replaced by what it execs; ``bash -c`` also execs the last command of its text by itself (bash
5.1 and later). dash and script files do not: there the shell stays, and what it starts are children.
"""

from __future__ import annotations

from bringup_lint.dataclass import dataclass
from bringup_lint.graph.commands.ros_command import Ros
from bringup_lint.graph.commands.ros_command import ros_command
from bringup_lint.graph.commands.shells import SCRIPT_DEPTH
from bringup_lint.graph.commands.shells import SHELL_SCRIPT
from bringup_lint.graph.commands.shells import SHELLS
from bringup_lint.graph.commands.shells import shell_input
from bringup_lint.graph.commands.wrappers import program_name
from bringup_lint.graph.commands.wrappers import unwrapped
from bringup_lint.graph.files import Files
from bringup_lint.graph.systemd.process import Process
from bringup_lint.model.shell import Command
from bringup_lint.named_tuple import NamedTuple
from bringup_lint.parsers.shell import commands
from bringup_lint.parsers.shell import script_text
from bringup_lint.pattern import regex
from bringup_lint.source import Located
from bringup_lint.source import Source
from bringup_lint.type_names import Literal

CONTAINERS = frozenset(
    {"docker", "podman", "docker-compose", "podman-compose", "systemd-nspawn", "lxc-start", "lxc", "nerdctl"}
)
_PYTHON = regex(r"python[0-9.]*$")
_PYTHON_SCRIPT = regex(r"#!\s*\S*/(?:env\s+(?:-S\s+)?)?python")
_BUILTINS = frozenset(
    (
        ": . [ [[ alias break cd continue declare echo eval exit export false hash kill let local printf "
        "pwd read return set shift source test trap true type ulimit umask unset wait"
    ).split()
)
"""Commands that bash runs itself, so that there is nothing to exec."""
_TRAPS = regex(r"\btrap\b")
_ALL_ARGUMENTS = ("$@", "$*")

Kind = Literal["launch", "run", "node", "cli", "shell", "lost", "python", "container", "program", "unknown"]


class Main(NamedTuple):
    """What the main process turns out to be."""

    kind: Kind
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


def main_process(process: Process, files: Files) -> Main:
    """The process that systemd takes for the main one, for Type= other than forking."""
    return _main(Command(process.argv), files, 0, None)


def _main(command: Command, files: Files, depth: int, script: Source | None) -> Main:
    words = unwrapped(command.words)
    if not words or depth > SCRIPT_DEPTH:
        return Main("unknown", command.words[-1])
    name = program_name(words[0])
    if name in CONTAINERS:
        return Main("container", words[0])
    found = ros_command(command)
    if found is not None:
        return Main(found.kind, found.where, found, script)
    if name in SHELLS:
        return _shell(name, words, files, depth)
    if _PYTHON.match(name):
        path = next((word for word in words[1:] if not word.startswith("-")), words[0])
        return Main("python", path, None, files.find(path, path.span.source) if path.startswith("/") else None)
    if "/" in words[0] and "$" not in words[0] and "%" not in words[0]:
        return _program(words, files, depth)
    return Main("unknown" if "$" in words[0] else "program", words[0])


def _program(words: tuple[Located, ...], files: Files, depth: int) -> Main:
    path = words[0]
    source = files.find(path, path.span.source)
    if source is not None and SHELL_SCRIPT.match(source.text):
        return _script(source, path, words[1:], files, depth)
    if source is not None and _PYTHON_SCRIPT.match(source.text):
        return Main("python", path, None, source)
    if source is None and path.endswith((".sh", ".bash")):
        return Main("lost", path)
    return Main("program", path)


def _shell(name: str, words: tuple[Located, ...], files: Files, depth: int) -> Main:
    read = shell_input(words[1:])
    if read is None:
        return Main("shell", words[0])
    if read.text is not None:
        shell = _Shell(words[0], read.arguments, None, execs_last=name == "bash")
        return _text(read.text, shell, files, depth)
    path = read.script or words[0]
    source = files.find(path, path.span.source) if path.startswith("/") and "$" not in path else None
    return Main("lost", path) if source is None else _script(source, path, read.arguments, files, depth)


def _script(source: Source, path: Located, arguments: tuple[Located, ...], files: Files, depth: int) -> Main:
    text = script_text(source)
    return _text(text, _Shell(path, arguments, source, execs_last=False), files, depth)


@dataclass(frozen=True)
class _Shell:
    """A shell that reads a text."""

    where: Located
    arguments: tuple[Located, ...]
    script: Source | None
    execs_last: bool
    """It execs the last command by itself."""


def _text(text: Located, shell: _Shell, files: Files, depth: int) -> Main:
    """What becomes of a shell that reads ``text``."""
    found = [command for command in commands(text) if command.words]
    execs = [command for command in found if command.words[0] == "exec" and len(command.words) > 1]
    taken = next((command for command in execs if not command.depth), None)
    if taken is None and execs:
        return Main("unknown", shell.where)
    if taken is None and shell.execs_last and not _TRAPS.search(text):
        taken = _execd_last(found)
    if taken is None:
        return Main("shell", shell.where, None, shell.script)
    words = _with_arguments(taken.words, shell.arguments)
    return _main(Command(words), files, depth + 1, shell.script) if words else Main("unknown", shell.where)


def _execd_last(found: list[Command]) -> Command | None:
    """The last command of a text, when a shell that execs the last command can exec it."""
    if not found:
        return None
    last, piped = found[-1], len(found) > 1 and found[-2].ends == "|"
    stays = last.depth or last.background or piped or last.name in _BUILTINS
    return None if stays else last


def _with_arguments(words: tuple[Located, ...], arguments: tuple[Located, ...]) -> tuple[Located, ...]:
    """The words with the arguments of the shell for ``"$@"``; none when nothing is left to start."""
    if not any(word in _ALL_ARGUMENTS for word in words):
        return words
    filled = tuple(other for word in words for other in (arguments if word in _ALL_ARGUMENTS else (word,)))
    return filled if len(filled) > 1 else ()
