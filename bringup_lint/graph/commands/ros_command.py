"""The ROS 2 program that a command starts: ``ros2 launch``, ``ros2 run``, an installed executable."""

from __future__ import annotations

from bringup_lint.dataclass import dataclass
from bringup_lint.graph.commands.wrappers import program_name
from bringup_lint.graph.commands.wrappers import unwrapped
from bringup_lint.model.shell import Command
from bringup_lint.pattern import regex
from bringup_lint.source import Located
from bringup_lint.type_names import Literal

INSTALLED_NODE = regex(r"/install/(?:[^/]+/)?lib/[^/]+/[^/]+$|/opt/ros/[^/]+/lib/[^/]+/[^/]+$", hints="lib/")


@dataclass(frozen=True, eq=False)
class Ros:
    """One ROS 2 program that a command starts."""

    kind: Literal["launch", "run", "node", "cli"]
    """``node``: an installed executable started by its path; ``cli``: another verb of ros2."""
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


def ros_command(command: Command) -> Ros | None:
    """The ROS 2 program that a command starts, if it is one; an entry script that is given ``ros2 launch`` runs it."""
    words = unwrapped(command.words)
    if not words:
        return None
    if program_name(words[0]) == "ros2" and len(words) > 1:
        return _ros2(command, words)
    if INSTALLED_NODE.search(words[0]):
        return Ros("node", command, None, words[0], words[1:])
    if "/" in words[0] and len(words) > 2 and words[1] == "ros2" and words[2] in ("launch", "run"):
        return ros_command(Command(words[1:]))
    return None


def _ros2(command: Command, words: tuple[Located, ...]) -> Ros:
    verb = words[1]
    if verb == "launch":
        return _launch(command, words[2:])
    if verb != "run":
        return Ros("cli", command, None, verb)
    named = [word for word in words[2:] if not word.startswith("-")]
    package, executable = named[:2] if len(named) > 1 else (None, None)
    return Ros("run", command, package, executable, words[4:])


def _launch(command: Command, words: tuple[Located, ...]) -> Ros:
    """``ros2 launch PACKAGE FILE`` or ``ros2 launch PATH``, with ``NAME:=VALUE`` arguments."""
    named = [word for word in words if not word.startswith("-") and ":=" not in word]
    arguments = tuple(word for word in words if ":=" in word)
    if not named:
        return Ros("launch", command, None, None, arguments)
    if len(named) == 1:
        return Ros("launch", command, None, named[0], arguments)
    return Ros("launch", command, named[0], named[1], arguments)
