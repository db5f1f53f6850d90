"""One command line, whoever runs it, with the steps that its shells and the scripts of the tree take."""

from __future__ import annotations

from collections.abc import Iterator
from functools import cached_property

from bringup_lint.dataclass import dataclass
from bringup_lint.dataclass import field
from bringup_lint.graph.commands.environment import SETUP_FILE
from bringup_lint.graph.commands.ros_command import Ros
from bringup_lint.graph.commands.ros_command import ros_command
from bringup_lint.graph.commands.shells import SHELLS
from bringup_lint.graph.commands.shells import profiles
from bringup_lint.model.shell import Command
from bringup_lint.pattern import regex
from bringup_lint.source import Located
from bringup_lint.source import Source
from bringup_lint.source import Span

_ROS1_TEXT = regex(
    r"/opt/ros/(?:noetic|melodic|kinetic|lunar|jade|indigo)\b|\b(?:roslaunch|rosrun|roscore)\b",
    0,
    "/opt/ros/ roslaunch rosrun roscore",
)
_ROS_TEXT = regex(
    r"\bros2 |/opt/ros/|install/(?:local_)?setup\.(?:bash|sh)|component_container",
    0,
    "ros2 /opt/ros/ install/ component_container",
)
_LAUNCH_TEXT = regex(r"\bros2\s+launch\b")
_TERMINALS = ("tmux", "screen", "byobu")
_ON_FILES = ("security", "pkg", "interface", "extensions", "extension_points")
"""Verbs of ros2 that start no node."""


@dataclass(frozen=True)
class Step:
    """A command with where it runs: which shell reads it, from which script."""

    command: Command
    shell: str = ""
    """``bash``, ``sh``...; empty when no shell is between the runner and the program."""
    script: Source | None = None
    """The script of the tree that holds the command; None for the command line itself."""
    last: bool = False
    """The last command of its shell text, at top level."""
    depth: int = 0
    """How many shells are between the runner and the command."""


@dataclass(eq=False)
class CommandLine:
    """One command line of a unit, a container, a script or another runner."""

    line: Located
    """The whole value."""
    argv: tuple[Located, ...]
    steps: list[Step] = field(default_factory=list)
    opaque: bool = False
    """It starts something that could not be followed, so that nothing it lacks can be called missing."""
    own_setups: set[Span] = field(default_factory=set)
    """Where files called ``setup.sh`` are sourced that are the robot's own, and whose commands are among the steps."""
    scripts_outside: list[Located] = field(default_factory=list)
    """The shell scripts that are started and that the tree does not hold."""

    @property
    def program(self) -> Located:
        return self.argv[0]

    @property
    def name(self) -> str:
        return self.program.rpartition("/")[2]

    @property
    def shell(self) -> str:
        """The shell that is started, or an empty string."""
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
    def launches_in_terminal(self) -> bool:
        """Whether ``ros2 launch`` only runs in a terminal of tmux or screen: no signal to the line reaches it."""
        commands = (step.command for step in self.steps)
        in_terminal = (word for command in commands if command.name in _TERMINALS for word in command.words)
        return not self.launches and any(_LAUNCH_TEXT.search(word) for word in in_terminal)

    @cached_property
    def setup_files(self) -> list[tuple[Step, Located]]:
        """The setup files that are sourced, in order; instead of a robot's own, which was followed, those in it."""
        return [
            (step, step.command.words[1])
            for step in self.steps
            if step.command.name in ("source", ".") and len(step.command.words) > 1
            if SETUP_FILE.search(step.command.words[1]) and step.command.words[1].span not in self.own_setups
        ]

    def sourced_before(self, step: Step) -> bool:
        """Whether a setup file is sourced before the step."""
        return any(self.steps.index(sourcing) < self.steps.index(step) for sourcing, _ in self.setup_files)

    @cached_property
    def profiles(self) -> list[tuple[Step, Located]]:
        """Where a shell is told to read what is meant for people: a sourced ``.bashrc``, ``bash -l``,
        ``bash -i``."""
        return [(step, word) for step in self.steps for word in profiles(step.command)]

    @cached_property
    def texts(self) -> list[str]:
        """The line and the scripts it starts."""
        return [str(self.line), *(script.text for script in scripts_of(self.steps))]

    @property
    def _said(self) -> list[str]:
        """The same without comments: what is planned there does not run."""
        return [str(self.line), *(script.uncommented for script in scripts_of(self.steps))]

    @property
    def mentions_ros(self) -> bool:
        """Whether the line, or a script it starts, has anything to do with nodes of ROS: ``ros2 security`` and its
        likes only work on files."""
        if self.ros and all(ros.kind == "cli" and ros.target in _ON_FILES for _, ros in self.ros):
            return False
        return bool(self.ros) or any(_ROS_TEXT.search(text) for text in self._said)

    @property
    def plans_ros(self) -> bool:
        """Whether only a comment of a script that it starts has to do with ROS 2."""
        return not self.mentions_ros and any(_ROS_TEXT.search(text) for text in self.texts)

    @property
    def is_ros1(self) -> bool:
        """Whether it is ROS 1 that is started."""
        return not self.ros and any(_ROS1_TEXT.search(text) for text in self._said)

    @property
    def script_outside_tree(self) -> Located | None:
        """The first shell script that is started and that the tree does not hold; a profile is none."""
        personal = {word for _, word in self.profiles}
        return next((each for each in self.scripts_outside if each not in personal), None)

    @property
    def replaces_shell(self) -> bool:
        """Whether the ROS program is the main process itself: run by systemd, exec'd, or the last of ``bash
        -c``."""
        for step, found in self.ros:
            words = [str(word) for word in found.command.words]
            if step.depth == 0 or words[0] == "exec" or (step.depth == 1 and step.last and self.shell == "bash"):
                return True
        return False


def scripts_of(steps: list[Step]) -> Iterator[Source]:
    """The scripts of the tree that the steps come from, each once."""
    yield from dict.fromkeys(step.script for step in steps if step.script)
