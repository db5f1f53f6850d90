"""Arguments that launch files give to xacro, and that the description does not declare."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from bringup_lint.graph.launch.resolve import text_of
from bringup_lint.graph.launch.started import literal_text
from bringup_lint.graph.launch.without_effect import is_empty
from bringup_lint.graph.plugins.xacro_includes import USED
from bringup_lint.graph.plugins.xacro_includes import description
from bringup_lint.model.launch_values import Command
from bringup_lint.model.launch_values import Concat
from bringup_lint.model.launch_values import Value
from bringup_lint.model.launch_values import walk
from bringup_lint.named_tuple import NamedTuple
from bringup_lint.pattern import regex
from bringup_lint.source import Located
from bringup_lint.source import Source

if TYPE_CHECKING:
    from bringup_lint.discover.tree import Tree
    from bringup_lint.graph.launch.launch import Launch

_GIVEN = regex(r"(?:^|(?<=\s))(\w+):=")
_SENSOR = regex(r"\$\(find[ \t]+realsense2_description[ \t]*\)/urdf/_\w+\.urdf\.xacro\Z")
_OF_SENSOR = ("add_plug", "use_nominal_extrinsics", "use_mesh")
"""The arguments that the macros of realsense2_description read (_d435.urdf.xacro and its likes)."""


class UnknownArgument(NamedTuple):
    name: Located
    description: Source
    known: tuple[str, ...]


def unknown_arguments(launch: Launch, tree: Tree) -> Iterator[UnknownArgument]:
    """Each argument once, where everything that the description includes is in the tree."""
    said: set[tuple[str, int]] = set()
    for node in launch.nodes:
        if not node.file.source.judged:
            continue
        for given in (*node.parameters, *node.arguments):
            for each in walk(given):
                if isinstance(each, Command) and isinstance(each.command, Concat):
                    yield from (one for one in _of_command(launch, tree, each.command) if _is_new(one, said))


def _is_new(found: UnknownArgument, said: set[tuple[str, int]]) -> bool:
    place = (found.name.span.source.name, found.name.span.start)
    is_new = place not in said
    said.add(place)
    return is_new


def _of_command(launch: Launch, tree: Tree, command: Concat) -> Iterator[UnknownArgument]:
    source = described_by(launch, tree, command)
    known = _declared(launch, tree, source) if source is not None else None
    if source is None or known is None:
        return
    for part, following in zip(command.parts[2:], (*command.parts[3:], None), strict=False):
        text = literal_text(part)
        given = [match for match in _GIVEN.finditer(text) if match.group(1) not in known] if text is not None else []
        for match in given:
            if text is not None and not is_empty(_value(text[match.end() :], following)):
                yield UnknownArgument(text.part(*match.span(1)), source, tuple(sorted(known)))


def _value(rest: str, following: Value | None) -> str | None:
    """What a launch file that is started without arguments gives after ``name:=``; None when that is not known."""
    return rest if rest or following is None else text_of(following)


def described_by(launch: Launch, tree: Tree, command: Concat) -> Source | None:
    """The file after ``xacro `` in a command."""
    program = literal_text(command.parts[0]) or ""
    at = 2 if program == "xacro" and (literal_text(command.parts[1]) or "x").isspace() else 1
    if program.strip() != "xacro" or len(command.parts) <= at:
        return None
    found = launch.find(command.parts[at])
    return tree.at(found.file) if found is not None and found.file is not None else None


def _declared(launch: Launch, tree: Tree, source: Source) -> set[str] | None:
    """The arguments of a description and of what it includes; None when something of it is not known."""
    whole = description(launch.workspace, tree, source, surely=False)
    if not whole.complete or not all(_SENSOR.match(filename) for filename in whole.missing):
        return None
    used = {name for file, _ in whole.files for name in USED.findall(file.text)}
    return {*whole.defaults, *used, *(_OF_SENSOR if whole.missing else ())}
