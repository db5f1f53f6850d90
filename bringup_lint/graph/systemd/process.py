"""What a unit really runs: the program of an Exec line, the shell text behind ``-c``, the scripts of the
tree that it starts.

systemd.service(5), "Command lines"; systemd replaces ``$$`` and known variables before the program sees them.
"""

from __future__ import annotations

import re
from collections.abc import Iterator
from dataclasses import dataclass
from dataclasses import field
from dataclasses import replace
from functools import cached_property
from typing import TYPE_CHECKING

from bringup_lint.graph.systemd.environment import SETUP_FILE
from bringup_lint.graph.systemd.unit import Unit
from bringup_lint.model.shell import Command
from bringup_lint.parsers.shell import commands
from bringup_lint.parsers.systemd_values import split_command_line
from bringup_lint.source import Located
from bringup_lint.source import Source

if TYPE_CHECKING:
    from bringup_lint.robot import Robot

EXEC_KEYS = (
    "ExecCondition",
    "ExecStartPre",
    "ExecStart",
    "ExecStartPost",
    "ExecReload",
    "ExecStop",
    "ExecStopPost",
)
_SHELL_OPTIONS = re.compile(r"[-+][A-Za-z]*[oO]|--rcfile|--init-file")
"""Options of shells that take a value."""
SHELLS = frozenset({"sh", "bash", "dash", "zsh", "ksh"})
SCRIPT_DEPTH = 4
"""How many scripts that call each other are followed."""

_PROFILE = re.compile(r"(?:^|/)(?:\.bashrc|\.bash_profile|\.profile|\.zshrc|bash\.bashrc|profile)$")
_LOGIN = re.compile(r"-[a-z]*[li][a-z]*")
SHELL_SCRIPT = re.compile(r"#!\s*\S*/(?:env\s+(?:-S\s+)?)?(sh|bash|dash|zsh|ksh)\b")
_INSTALLED_NODE = re.compile(r"/install/(?:[^/]+/)?lib/[^/]+/[^/]+$|/opt/ros/[^/]+/lib/[^/]+/[^/]+$")
_WRAPPERS = {
    "exec": ("-a", 0),
    "command": ("", 0),
    "nohup": ("", 0),
    "setsid": ("", 0),
    "time": ("-f -o", 0),
    "nice": ("-n", 0),
    "ionice": ("-c -n", 0),
    "chrt": ("-T -P -D", 1),
    "taskset": ("", 1),
    "timeout": ("-k -s", 1),
    "stdbuf": ("-i -o -e", 0),
    "env": ("-u -C", 0),
    "sudo": ("-u -g -h -p -C -r -t -U -D -R", 0),
    "setpriv": (
        "--reuid --regid --ruid --euid --rgid --egid --groups --inh-caps --ambient-caps --bounding-set",
        0,
    ),
    "runuser": ("-u -g -G", 0),
    "gosu": ("", 1),
    "su-exec": ("", 1),
    "prlimit": ("", 0),
    "unshare": ("", 0),
    "systemd-inhibit": ("", 0),
    "systemd-cat": ("-t -p", 0),
    "dbus-run-session": ("", 0),
    "xvfb-run": ("-e -f -n -p -s -w", 0),
}
"""Programs that run another one: their options that take a value, and how many words of their own they
need."""
_ROS1_TEXT = re.compile(r"/opt/ros/(?:noetic|melodic|kinetic|lunar|jade|indigo)\b|\broslaunch\b|\broscore\b")
_ROS_TEXT = re.compile(r"\bros2 |/opt/ros/|install/(?:local_)?setup\.(?:bash|sh)|component_container")

_ON_FILES = ("security", "pkg", "interface", "extensions", "extension_points")
"""Verbs of ros2 that start no node."""


@dataclass(frozen=True)
class Ros:
    """One ROS 2 program that a unit starts."""

    kind: str
    """``launch``, ``run``, ``node`` (an installed executable started by its path), or ``cli`` (another ros2
    verb)."""
    command: Command
    package: Located | None = None
    target: Located | None = None
    """The launch file or executable."""
    arguments: tuple[Located, ...] = ()

    @property
    def where(self) -> Located:
        return self.target or self.command.words[-1]

    @property
    def program(self) -> Located:
        """What is started, wrappers such as ``exec`` and ``nice`` left out."""
        return unwrapped(self.command.words)[0]


@dataclass(frozen=True)
class Step:
    """A command with where it runs: which shell reads it, from which script."""

    command: Command
    shell: str = ""
    """``bash``, ``sh``...; empty when systemd runs the program itself."""
    script: Source | None = None
    """The script of the tree that holds the command; None for the Exec line itself."""
    last: bool = False
    """The last command of its shell text, at top level."""
    depth: int = 0
    """How many shells stand between systemd and the command."""


@dataclass(eq=False)
class Process:
    """One command line of a unit."""

    unit: Unit
    key: str
    line: Located
    """The whole value."""
    prefixes: str
    argv: tuple[Located, ...]
    steps: list[Step] = field(default_factory=list)
    opaque: bool = False
    """It starts something that could not be followed, so that nothing it lacks can be called missing."""
    _lost: list[Located] = field(default_factory=list)

    @property
    def program(self) -> Located:
        return self.argv[0]

    @property
    def name(self) -> str:
        return self.program.rpartition("/")[2]

    @property
    def shell(self) -> str:
        """The shell that systemd starts, or an empty string."""
        return self.name if self.name in SHELLS else ""

    @cached_property
    def ros(self) -> list[tuple[Step, Ros]]:
        """The ROS 2 programs that the steps start."""
        programs = ((step, found) for step in self.steps if (found := ros_command(step.command)))
        return list({found.where.span: (step, found) for step, found in programs}.values())

    @cached_property
    def launches(self) -> list[tuple[Step, Ros]]:
        return [(step, found) for step, found in self.ros if found.kind == "launch"]

    @cached_property
    def setup_files(self) -> list[tuple[Step, Located]]:
        """The setup files that are sourced, in order."""
        return [
            (step, step.command.words[1])
            for step in self.steps
            if step.command.name in ("source", ".") and len(step.command.words) > 1
            if SETUP_FILE.search(step.command.words[1])
        ]

    def sourced_before(self, step: Step) -> bool:
        """Whether a setup file is sourced before the step."""
        return any(self.steps.index(sourcing) < self.steps.index(step) for sourcing, _ in self.setup_files)

    @cached_property
    def profiles(self) -> list[tuple[Step, Located]]:
        """Where a shell is told to read what is meant for people: a sourced ``.bashrc``, ``bash -l``,
        ``bash -i``."""
        return list(_profiles(self.steps))

    @cached_property
    def texts(self) -> list[str]:
        """The line and the scripts it starts."""
        return [
            str(self.line),
            *{id(step.script): step.script.text for step in self.steps if step.script}.values(),
        ]

    @property
    def mentions_ros(self) -> bool:
        """Whether the line, or a script it starts, has anything to do with nodes of ROS: ``ros2 security`` and its
        likes only work on files."""
        if self.ros and all(ros.kind == "cli" and ros.target in _ON_FILES for _, ros in self.ros):
            return False
        return bool(self.ros) or any(_ROS_TEXT.search(text) for text in self.texts)

    @property
    def is_ros1(self) -> bool:
        """Whether it is ROS 1 that is started."""
        return not self.ros and any(_ROS1_TEXT.search(text) for text in self.texts)

    @property
    def lost_script(self) -> Located | None:
        """The first shell script that is started and that the tree does not hold."""
        return self._lost[0] if self._lost else None

    @property
    def replaces_shell(self) -> bool:
        """Whether the ROS program is the main process itself: run by systemd, exec'd, or the last of ``bash
        -c``."""
        for step, found in self.ros:
            words = [str(word) for word in found.command.words]
            if step.depth == 0 or words[0] == "exec" or (step.depth == 1 and step.last and self.shell == "bash"):
                return True
        return False


def _profiles(steps: list[Step]) -> Iterator[tuple[Step, Located]]:
    for step in steps:
        words = unwrapped(step.command.words)
        name = words[0].rpartition("/")[2] if words else ""
        if name in ("source", ".") and len(words) > 1 and _PROFILE.search(words[1]):
            yield step, words[1]
        elif name in SHELLS:
            for word in words[1:]:
                if not word.startswith("-"):
                    break
                if word == "--login" or _LOGIN.fullmatch(word):
                    yield step, word
                if not word.startswith("--") and "c" in word:
                    break


def processes(unit: Unit, robot: Robot) -> list[Process]:
    """The command lines of a service, in the order of ``EXEC_KEYS``, with what their shells and scripts
    run."""
    found = []
    for key in EXEC_KEYS:
        for value in unit.values(key, "Service"):
            for line in split_command_line(value).commands:
                if line.argv:
                    process = Process(unit, key, value, line.prefixes, tuple(line.argv))
                    process.steps = list(_steps(process, robot))
                    found.append(process)
    return found


def _steps(process: Process, robot: Robot) -> Iterator[Step]:
    command = Command(process.argv)
    yield Step(command, last=True)
    yield from _followed(process, command, robot, 1)


def _followed(process: Process, command: Command, robot: Robot, depth: int) -> Iterator[Step]:
    """The steps behind a command that is a shell or a script of the tree."""
    words = unwrapped(command.words)
    if not words or depth > SCRIPT_DEPTH:
        return
    name = words[0].rpartition("/")[2]
    if name in SHELLS:
        yield from _shell(process, name, words[1:], robot, depth)
    elif name == "su":
        process.opaque = True
    elif "/" in words[0] and name != "ros2" and not _INSTALLED_NODE.search(words[0]):
        yield from _script(process, words[0], "", words[1:], robot, depth)
    elif name in ("source", ".") and len(words) > 1 and not SETUP_FILE.search(words[1]):
        yield from _script(process, words[1], "bash", (), robot, depth)


def _shell(process: Process, name: str, words: tuple[Located, ...], robot: Robot, depth: int) -> Iterator[Step]:
    at = 0
    while at < len(words):
        word = words[at]
        if _SHELL_OPTIONS.fullmatch(word):
            at += 2
        elif word.startswith("-") and not word.startswith("--") and "c" in word and at + 1 < len(words):
            yield from _text(process, words[at + 1], name, None, words[at + 3 :], robot, depth)
            return
        elif word.startswith(("-", "+")):
            at += 1
        else:
            yield from _script(process, word, name, words[at + 1 :], robot, depth)
            return
    process.opaque = True


def _script(
    process: Process, path: Located, shell: str, arguments: tuple[Located, ...], robot: Robot, depth: int
) -> Iterator[Step]:
    known = path.startswith("/") and "$" not in path and "%" not in path
    source = robot.find(path, path.span.source) if known else None
    shebang = SHELL_SCRIPT.match(source.text) if source else None
    if source is None or not (shell or shebang):
        process.opaque = True
        if source is None and (shell or path.endswith((".sh", ".bash"))):
            process._lost.append(path)
        return
    if any(step.script is source for step in process.steps):
        return
    text = source.located(0, len(source.text))
    yield from _text(process, text, shell or shebang[1], source, arguments, robot, depth)


def _text(
    process: Process,
    text: Located,
    shell: str,
    script: Source | None,
    arguments: tuple[Located, ...],
    robot: Robot,
    depth: int,
) -> Iterator[Step]:
    found = commands(text)
    for at, command in enumerate(found):
        if arguments and unwrapped(command.words) == ("$@",):
            command = replace(command, words=(*command.words[:-1], *arguments))
        yield Step(command, shell, script, at == len(found) - 1 and command.depth == 0, depth)
        yield from _followed(process, command, robot, depth + 1)


def unwrapped(words: tuple[Located, ...]) -> tuple[Located, ...]:
    """The words without ``exec``, ``nice -n 5``, ``sudo -u rover``, ``env A=1`` and the like in front."""
    while words and (wrapper := _WRAPPERS.get(words[0].rpartition("/")[2])):
        options, own = wrapper
        at = 1
        while at < len(words) and (words[at].startswith("-") or "=" in words[at]):
            at += 2 if words[at] in options.split() else 1
            if words[at - 1] == "--":
                break
        words = words[at + own :]
    return words


def ros_command(command: Command) -> Ros | None:
    """The ROS 2 program that a command starts, if it is one; an entry script that is given ``ros2 launch
    ...`` execs it."""
    words = unwrapped(command.words)
    if not words:
        return None
    name = words[0].rpartition("/")[2]
    if name == "ros2" and len(words) > 1:
        verb = str(words[1])
        rest = [word for word in words[2:] if not word.startswith("-")]
        if verb == "launch":
            named = [word for word in rest if ":=" not in word]
            arguments = tuple(word for word in words[2:] if ":=" in word)
            if len(named) == 1:
                return Ros("launch", command, None, named[0], arguments)
            return Ros("launch", command, *(named[:2] or (None, None)), arguments)
        if verb == "run":
            return Ros("run", command, *(rest[:2] if len(rest) > 1 else (None, None)), tuple(words[4:]))
        return Ros("cli", command, None, words[1])
    if _INSTALLED_NODE.search(words[0]):
        return Ros("node", command, None, words[0], words[1:])
    if "/" in words[0] and len(words) > 2 and words[1] == "ros2" and words[2] in ("launch", "run"):
        return ros_command(Command(words[1:]))
    return None
