"""``ros2 launch`` on a command line: who runs it, which launch file it names, and what that leads to."""

from __future__ import annotations

from bringup_lint.named_tuple import NamedTuple
from bringup_lint.pattern import regex
from bringup_lint.type_names import TYPE_CHECKING

if TYPE_CHECKING:
    from bringup_lint.graph.commands.ros_command import Ros
    from bringup_lint.graph.launch.expansion import Expansion
    from bringup_lint.graph.launch.launch import Launch
    from bringup_lint.graph.runners.runner import Runner
    from bringup_lint.graph.runners.runner import Start
    from bringup_lint.model.launch import LaunchFile
    from bringup_lint.model.launch_values import Value
    from bringup_lint.source import Located

_EXPANDED = regex(r"[$`*?%]")
"""What a shell or systemd replaces."""


class Launching(NamedTuple):
    runner: Runner
    start: Start
    file: LaunchFile | None
    """The launch file, when it is in the tree."""

    @property
    def package(self) -> Located | None:
        return self.start.ros.package

    @property
    def target(self) -> Located:
        """The name of the launch file, as the command gives it."""
        return self.start.ros.where

    @property
    def arguments(self) -> list[tuple[Located, Located]]:
        return self.start.arguments


def expansion_of(ros: Ros, launch: Launch) -> Expansion | None:
    """What ``ros2 launch`` leads to with its arguments; None when its file is not in the tree."""
    file = launch.named(ros.package, ros.target) if ros.kind == "launch" else None
    if file is None:
        return None
    from bringup_lint.model.launch_values import Literal
    from bringup_lint.model.launch_values import Unknown

    arguments: dict[str, Value] = {}
    for word in ros.arguments:
        name, colon, text = word.partition(":=")
        value = word.part(len(name) + 2, len(word))
        if colon:
            arguments[name] = Unknown("shell", word.span) if _EXPANDED.search(text) else Literal(value, value.span)
    return launch.expand(file, arguments) if arguments else launch.expansion(file)
