"""What comes after ``--ros-args`` on the command line of a launched node: remappings and parameters."""

from __future__ import annotations

from collections.abc import Iterator

from bringup_lint.dataclass import dataclass
from bringup_lint.dataclass import field
from bringup_lint.graph.launch.resolve import text_of
from bringup_lint.graph.launch.started import Started
from bringup_lint.graph.topics.resolved.remapping import Remapping
from bringup_lint.graph.topics.resolved.remapping import remapping
from bringup_lint.model.launch_values import Concat
from bringup_lint.model.launch_values import Env
from bringup_lint.model.launch_values import FileDir
from bringup_lint.model.launch_values import PackageShare
from bringup_lint.model.launch_values import PathJoin
from bringup_lint.model.launch_values import Value
from bringup_lint.parsers.shell import split
from bringup_lint.source import Span

_REMAP = ("-r", "--remap")
_PARTS = (Concat, Env, FileDir, PackageShare, PathJoin)
"""Values that are one word with something unknown in it, such as a path: no option of ROS."""
_PARAMETER = ("-p", "--param")


@dataclass(eq=False)
class RosArguments:
    remappings: list[Remapping] = field(default_factory=list)
    parameters: list[tuple[str, str, Span]] = field(default_factory=list)
    """Name, text of the value, place."""
    known: bool = True
    """False when something may be remapped or set in a way that is not known."""


def ros_arguments(node: Started) -> RosArguments:
    """Launch puts them before what it adds itself, so that their remappings win."""
    found = RosArguments()
    if node.is_node and not hasattr(node.action, "plugin"):
        words = list(_words(node.arguments))
        for at, (text, value) in enumerate(words):
            if text is None:
                found.known &= isinstance(value, _PARTS)
            elif text in _REMAP or text in _PARAMETER:
                _take(found, text, words[at + 1] if at + 1 < len(words) else None)
            elif text == "--params-file":
                found.known = False
    return found


def _words(values: tuple[Value, ...]) -> Iterator[tuple[str | None, Value]]:
    """Launch hands every argument over as one word, with its blanks; only text before ``:=`` matters here."""
    for value in values:
        text = text_of(value)
        if text is not None and text.split(" ")[0] in (*_REMAP, *_PARAMETER) and " " in text:
            yield from ((word, value) for word in split(text))
        else:
            yield text, value


def _take(found: RosArguments, option: str, following: tuple[str | None, Value] | None) -> None:
    text, value = following if following is not None else (None, None)
    if text is None or value is None:
        found.known = False
        return
    if option in _REMAP:
        rule = remapping(text, value.span)
        if rule is not None:
            found.remappings.append(rule)
    else:
        name, colon, rest = text.partition(":=")
        if colon:
            found.parameters.append((name.rpartition(":")[2], rest, value.span))
