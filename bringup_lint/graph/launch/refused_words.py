"""Words that launch files hand to programs in a form that these cannot use."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from bringup_lint.graph.launch.started import Started
from bringup_lint.graph.launch.started import literal_text
from bringup_lint.model.launch import ComposableNode
from bringup_lint.model.launch import Node
from bringup_lint.model.launch import Process
from bringup_lint.model.launch_values import Argument
from bringup_lint.model.launch_values import Concat
from bringup_lint.model.launch_values import PathJoin
from bringup_lint.model.launch_values import Value
from bringup_lint.model.launch_values import understood
from bringup_lint.pattern import regex
from bringup_lint.source import Located

if TYPE_CHECKING:
    from bringup_lint.graph.launch.launch import Launch

_PROGRAM = regex(r"[a-z][\w.+-]*\s+\S")
"""A program without its path, and the first of its arguments."""
_LENGTHS = (0, 8, 9)
"""Words of static_transform_publisher (geometry2, static_transform_broadcaster_program.cpp)."""
_TRANSFORM = ("tf2_ros", "static_transform_publisher")


def unsplit_commands(launch: Launch) -> Iterator[Value]:
    """Commands of ``ExecuteProcess`` in one word, which launch does not give to a shell."""
    for file, action in launch.actions(Process):
        if isinstance(action, Node) or file.source.kind != "launch-python" or action.open:
            continue
        if action.cmd and "shell" not in action.options and _is_unsplit(action.cmd[0]):
            yield action.cmd[0]


def _is_unsplit(program: Value) -> bool:
    text = literal_text(program)
    return bool(_PROGRAM.match(text)) if text is not None else _goes_on(program)


def _goes_on(value: Value) -> bool:
    """Whether text after a blank follows a part that is computed."""
    if not isinstance(value, Concat):
        return False
    texts = (literal_text(part) for part in value.parts[1:])
    return any(text is not None and text[:1].isspace() and text.strip() for text in texts)


def unsplit_ros_arguments(launch: Launch) -> Iterator[Located]:
    for node in _given(launch):
        for text in map(literal_text, node.arguments):
            if text is not None and text.startswith("--ros-args ") and text.span.source.kind == "launch-python":
                yield text


def refused_transforms(launch: Launch) -> Iterator[tuple[Started, int]]:
    """The starts of static_transform_publisher that it refuses, with the number of its arguments."""
    for node in _given(launch):
        if (literal_text(node.package), literal_text(node.executable)) != _TRANSFORM:
            continue
        words = list(_own(node))
        is_known = not any(word is None or word.startswith("-h") or word.startswith("--") for word in words)
        if is_known and len(words) not in _LENGTHS:
            yield node, len(words)


def _given(launch: Launch) -> Iterator[Started]:
    """The nodes of judged launch files all of whose arguments are known."""
    judged = {id(file) for file in launch.judged}
    for node in launch.nodes:
        is_open = isinstance(node.action, ComposableNode) or getattr(node.action, "open", False)
        if id(node.file) in judged and node.is_node and not is_open:
            yield node


def _own(node: Started) -> Iterator[Located | str | None]:
    """The words before the ROS arguments; None for one that may be several."""
    for value in node.arguments:
        text = literal_text(value)
        if text == "--ros-args":
            return
        if text is not None:
            yield text
        else:
            is_one = isinstance(value, (Argument, Concat, PathJoin)) and understood(value)
            yield "?" if is_one else None
