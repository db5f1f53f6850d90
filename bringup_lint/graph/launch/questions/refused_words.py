"""Words that launch files hand to programs in a form that these cannot use."""

from __future__ import annotations

import itertools
import math
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
_NO_COMMA = regex(r"""(['"])(--?[A-Za-z](?:[\w-]{0,60}\w))\1\s+['"][^\s='"]""")
"""An option, and another text behind it. Not one letter: programs take ``-y0.8`` for ``-y 0.8``."""
_LENGTHS = (0, 8, 9)
"""Words of static_transform_publisher (geometry2, static_transform_broadcaster_program.cpp)."""
_MOST_RADIANS = 2 * math.pi + 0.01
_BRIDGE = regex(r"(?P<name>[^@]+)@(?P<ros>[^@\[\]]*)[@\[\]](?P<gz>[^@]+)\Z")
"""What parameter_bridge of ros_gz_bridge takes for a topic."""
_SERVICE = "/srv/"
_OF_ROS = regex(r"\w+/msg/\w+\Z")
_OF_GAZEBO = regex(r"(?:gz|ignition)\.msgs\.\w+\Z")
_BRIDGES = (("ros_gz_bridge", "parameter_bridge"), ("ros_ign_bridge", "parameter_bridge"))
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


def options_with_next(launch: Launch) -> Iterator[tuple[Located, str]]:
    """The words of options that Python joins with the text after them, where a comma is missing; and the option."""
    for file, action in launch.actions(Process):
        words = (*action.cmd, *(action.arguments if isinstance(action, Node) else ()))
        for text in map(literal_text, words if file.source.kind == "launch-python" else ()):
            found = _NO_COMMA.match(text.span.text) if text is not None and text.startswith("-") else None
            if text is not None and found is not None:
                yield text, found[2]


def unsplit_ros_arguments(launch: Launch) -> Iterator[Located]:
    for node in _given(launch):
        for text in map(literal_text, node.arguments):
            if text is not None and text.startswith("--ros-args ") and text.span.source.kind == "launch-python":
                yield text


def refused_transforms(launch: Launch) -> Iterator[tuple[Started, int]]:
    """The starts of static_transform_publisher that it refuses, with the number of its arguments."""
    for node in _transforms(launch):
        words = list(_own(node))
        is_known = not any(word is None or word.startswith("-h") or word.startswith("--") for word in words)
        if is_known and len(words) not in _LENGTHS:
            yield node, len(words)


def unknown_flags(launch: Launch) -> Iterator[Located]:
    """The first flag of static_transform_publisher where it takes the words in their order only."""
    for node in _transforms(launch):
        flags = (text for text in map(literal_text, node.arguments) if text is not None and text.startswith("--"))
        first = next(flags, None)
        if first is not None and first != "--ros-args":
            yield first


def in_degrees(launch: Launch) -> Iterator[tuple[Located, float]]:
    """The angles of static transforms that are more than a full turn of radians."""
    for node in _transforms(launch):
        words = [literal_text(value) for value in node.arguments]
        for text in _angles(words):
            number = _number(text)
            if number is not None and abs(number) > _MOST_RADIANS:
                yield text, number


def unbridged(launch: Launch) -> Iterator[tuple[Located, str | None]]:
    """The words of bridges to Gazebo that end the bridge, or name a type that it cannot know: with that type."""
    for node in _given(launch):
        if (literal_text(node.package), literal_text(node.executable)) in _BRIDGES:
            for word in itertools.takewhile(lambda each: each != "--ros-args", map(literal_text, node.arguments)):
                if word is not None and _SERVICE not in word:
                    yield from _unbridged(word)


def _unbridged(word: Located) -> Iterator[tuple[Located, str | None]]:
    found = _BRIDGE.match(word)
    if found is None:
        yield word, None
    elif not _OF_ROS.match(found["ros"]):
        yield word, found["ros"]
    elif not _OF_GAZEBO.match(found["gz"]):
        yield word, found["gz"]


def turned(launch: Launch) -> Iterator[tuple[Argument, Argument]]:
    """The arguments of launch files that a static transform gets as its yaw and roll, where they are called the other
    way round."""
    for node in _transforms(launch):
        words: tuple[Value, ...] = getattr(node.action, "arguments", ())
        flags = (text for text in map(literal_text, words) if text is not None and text.startswith("--"))
        if len(words) != _LENGTHS[1] or next(flags, None) is not None:
            continue
        first, last = words[3], words[5]
        if isinstance(first, Argument) and isinstance(last, Argument):
            if first.name.lower().endswith("roll") and last.name.lower().endswith("yaw"):
                yield first, last


def _angles(words: list[Located | None]) -> Iterator[Located]:
    """The values of yaw, pitch and roll, by their flags or in the order of eight words."""
    own = list(itertools.takewhile(lambda word: word != "--ros-args", words))
    for before, after in itertools.pairwise(own):
        if before in ("--yaw", "--pitch", "--roll") and after is not None:
            yield after
    if len(own) == _LENGTHS[1] and not any(word is not None and word.startswith("--") for word in own):
        yield from (word for word in own[3:6] if word is not None)


def _number(text: str) -> float | None:
    try:
        return float(text)
    except ValueError:
        return None


def _transforms(launch: Launch) -> Iterator[Started]:
    for node in _given(launch):
        if (literal_text(node.package), literal_text(node.executable)) == _TRANSFORM:
            yield node


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
