"""Commands of launch files whose parts lack the blanks between their words."""

from __future__ import annotations

import re
from collections.abc import Iterator
from itertools import accumulate
from itertools import islice
from typing import TYPE_CHECKING

from bringup_lint.graph.launch.started import literal_text
from bringup_lint.model.launch import ComposableNode
from bringup_lint.model.launch_values import Argument
from bringup_lint.model.launch_values import Command
from bringup_lint.model.launch_values import Concat
from bringup_lint.model.launch_values import FileDir
from bringup_lint.model.launch_values import PackagePrefix
from bringup_lint.model.launch_values import PackageShare
from bringup_lint.model.launch_values import PathJoin
from bringup_lint.model.launch_values import Value
from bringup_lint.model.launch_values import walk
from bringup_lint.named_tuple import NamedTuple
from bringup_lint.pattern import regex

if TYPE_CHECKING:
    from bringup_lint.graph.launch.launch import Launch

_PATHS = (PackageShare, PackagePrefix, PathJoin, FileDir)
_DESCRIPTIONS = (".urdf", ".xacro", ".sdf")
_PATH, _GIVEN, _UNKNOWN = "\1", "\2", "\3"
"""What stands for a part of a command that is not literal: a path, an argument of the launch file, and all else."""
_WORD = regex(r"\S+")
_OPTION = regex(r"\b\w+:=")
_AFTER_FILE = regex(r"(?:\x01|\x02(?=[A-Za-z_]))(?:/[\w/.-]*\.(?:urdf|xacro|sdf))?(?P<name>[A-Za-z_]\w*):=")
_PROGRAMS = ("xacro", "ros2 run xacro xacro", "cat")
_FILE = regex(r"(?:(?:ros2 run xacro )?xacro|cat)[ \t]+(?P<file>[\x01\x02])")


class Joined(NamedTuple):
    """Two words of a command that launch makes one."""

    how: str
    """``program``: its name goes on with the path. ``file``: the name of the file goes on with an option. ``option``:
    a value goes on with the next option. ``description``: a robot description alone, which is no program."""
    place: Value
    """The part with the end or the beginning of the second word."""
    text: str
    """The option that the name of the file goes on with, or the whole word."""


def joined_commands(launch: Launch) -> Iterator[Joined]:
    """Each command of a judged file once, whose parts are joined without the blanks that it needs."""
    judged = {id(file) for file in launch.judged}
    seen = set()
    for node in launch.nodes:
        is_open = isinstance(node.action, ComposableNode) or getattr(node.action, "open", False)
        if id(node.file) not in judged or not node.is_node or is_open:
            continue
        for given in (*node.parameters, *node.arguments):
            for each in walk(given):
                if isinstance(each, Command) and each.span not in seen:
                    seen.add(each.span)
                    yield from _of_command(each.command)


def _of_command(command: Value) -> Iterator[Joined]:
    parts = command.parts if isinstance(command, Concat) else (command,)
    signs = [_sign(part) for part in parts]
    text = "".join(signs)
    starts = list(accumulate(map(len, signs), initial=0))
    if not _WORD.search(text) or _UNKNOWN in text:
        return
    if len(parts) > 1 and literal_text(parts[0]) in _PROGRAMS and (signs[1] == _PATH or _is_description(parts[1])):
        yield Joined("program", parts[0], "")
        return
    if len(text.split()) == 1 and _is_description(parts[-1]):
        yield Joined("program" if text.startswith("xacro") else "description", parts[0], "")
        return
    named = _FILE.match(text)
    for word in _WORD.finditer(text):
        is_file = named is not None and word.start() == named.start("file")
        lost = _of_file(word[0]) if is_file else _of_value(word[0])
        if lost is not None:
            at = word.start() + lost.end()
            place = next(part for part, end in zip(parts, starts[1:]) if at <= end)
            shown = lost["name"] if is_file else word[0]
            yield Joined("file" if is_file else "option", place, shown.replace(_PATH, "…").replace(_GIVEN, "…"))


def _of_file(word: str) -> re.Match[str] | None:
    """The option with which the name of a file goes on."""
    return _AFTER_FILE.match(word)


def _of_value(word: str) -> re.Match[str] | None:
    """The second option in a word."""
    options = list(islice(_OPTION.finditer(word), 2))
    return options[1] if len(options) == 2 else None


def _sign(part: Value) -> str:
    text = literal_text(part)
    if text is not None:
        return str(text)
    if isinstance(part, _PATHS):
        return _PATH
    return _GIVEN if isinstance(part, Argument) else _UNKNOWN


def _is_description(path: Value | None) -> bool:
    if isinstance(path, (Concat, PathJoin)) and path.parts:
        path = path.parts[-1]
    text = literal_text(path) if path is not None else None
    return text is not None and text.endswith(_DESCRIPTIONS)
