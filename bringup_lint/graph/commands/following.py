"""What a command line really runs: the shell text after ``-c``, and the scripts of the tree that it starts."""

from __future__ import annotations

from collections.abc import Callable
from collections.abc import Iterator

from bringup_lint.dataclass import dataclass
from bringup_lint.dataclass import field
from bringup_lint.dataclass import replace
from bringup_lint.graph.commands.command_line import CommandLine
from bringup_lint.graph.commands.command_line import Step
from bringup_lint.graph.commands.environment import SETUP_FILE
from bringup_lint.graph.commands.ros_command import INSTALLED_NODE
from bringup_lint.graph.commands.shells import SCRIPT_DEPTH
from bringup_lint.graph.commands.shells import SHELL_SCRIPT
from bringup_lint.graph.commands.shells import SHELLS
from bringup_lint.graph.commands.shells import shell_input
from bringup_lint.graph.commands.wrappers import unwrapped
from bringup_lint.model.shell import Command
from bringup_lint.parsers.shell import commands
from bringup_lint.parsers.shell import script_text
from bringup_lint.pattern import regex
from bringup_lint.source import Located
from bringup_lint.source import Source

_GENERATED = regex(r"/(?:install|devel|opt/ros/\w+)/(?:local_)?setup\.\w+\Z", hints="setup.")
"""Setup files that colcon, catkin and the packages of ROS write."""

Find = Callable[[Located], Source | None]
"""The file of the tree that a path of a command means to whoever runs it."""


def follow(line: CommandLine, find: Find) -> None:
    """Fill in the steps of a command line, and what of it could not be followed."""
    command = Command(line.argv)
    line.steps = [Step(command, last=True), *_Follower(line, find).behind(command, 1)]


def follow_text(line: CommandLine, text: Located, find: Find) -> None:
    """The same for a text that a shell reads."""
    line.steps = list(_Follower(line, find).text(text, "sh", None, (), 1))


@dataclass(eq=False)
class _Follower:
    line: CommandLine
    find: Find
    read: set[Source] = field(default_factory=set)
    """The scripts that were followed: each is followed once."""

    def behind(self, command: Command, depth: int) -> Iterator[Step]:
        """The steps of a command that is a shell or a script of the tree."""
        words = unwrapped(command.words)
        if not words or depth > SCRIPT_DEPTH:
            return
        name = words[0].rpartition("/")[2]
        if name in SHELLS:
            yield from self.shell(name, words[1:], depth)
        elif name == "su":
            self.line.opaque = True
        elif "/" in words[0] and name != "ros2" and not INSTALLED_NODE.search(words[0]):
            yield from self.script(words[0], "", words[1:], depth)
        elif name in ("source", ".") and len(words) > 1 and self.is_own(words[1]):
            yield from self.script(words[1], "bash", (), depth)

    def is_own(self, path: Located) -> bool:
        """Whether a sourced file is the robot's own: a ``setup.sh`` is where the tree holds it outside install/."""
        if not SETUP_FILE.search(path):
            return True
        if _GENERATED.search(path) or "$" in path or "%" in path or self.find(path) is None:
            return False
        self.line.own_setups.add(path.span)
        return True

    def shell(self, name: str, words: tuple[Located, ...], depth: int) -> Iterator[Step]:
        read = shell_input(words)
        if read is None:
            self.line.opaque = True
        elif read.text is not None:
            yield from self.text(read.text, name, None, read.arguments, depth)
        elif read.script is not None:
            yield from self.script(read.script, name, read.arguments, depth)

    def script(self, path: Located, shell: str, arguments: tuple[Located, ...], depth: int) -> Iterator[Step]:
        source = None if "$" in path or "%" in path else self.find(path)
        shebang = SHELL_SCRIPT.match(source.text) if source else None
        if source is None or not (shell or shebang):
            self.line.opaque = True
            if source is None and (shell or path.endswith((".sh", ".bash"))):
                self.line.scripts_outside.append(path)
            return
        if source in self.read:
            return
        self.read.add(source)
        text = script_text(source)
        yield from self.text(text, shell or (shebang[1] if shebang else ""), source, arguments, depth)

    def text(
        self, text: Located, shell: str, script: Source | None, arguments: tuple[Located, ...], depth: int
    ) -> Iterator[Step]:
        found = commands(text)
        for at, command in enumerate(found):
            if arguments and unwrapped(command.words) == ("$@",):
                command = replace(command, words=(*command.words[:-1], *arguments))
            yield Step(command, shell, script, at == len(found) - 1 and command.depth == 0, depth)
            yield from self.behind(command, depth + 1)
