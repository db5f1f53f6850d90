"""The ROS 2 program that a command starts: ``ros2 launch``, ``ros2 run``, an installed executable."""

from __future__ import annotations

import re
from dataclasses import dataclass

from bringup_lint.graph.commands.wrappers import unwrapped
from bringup_lint.model.shell import Command
from bringup_lint.source import Located

INSTALLED_NODE = re.compile(r"/install/(?:[^/]+/)?lib/[^/]+/[^/]+$|/opt/ros/[^/]+/lib/[^/]+/[^/]+$")


@dataclass(frozen=True, eq=False)
class Ros:
    """One ROS 2 program that a command starts."""

    kind: str
    """``launch``, ``run``, ``node`` (an installed executable started by its path), or ``cli`` (another verb)."""
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
    if INSTALLED_NODE.search(words[0]):
        return Ros("node", command, None, words[0], words[1:])
    if "/" in words[0] and len(words) > 2 and words[1] == "ros2" and words[2] in ("launch", "run"):
        return ros_command(Command(words[1:]))
    return None
