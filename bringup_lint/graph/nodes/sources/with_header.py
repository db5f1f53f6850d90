"""A C++ source together with its header."""

from __future__ import annotations

from typing import TYPE_CHECKING

from bringup_lint.graph.memo import kept

if TYPE_CHECKING:
    from bringup_lint.graph.nodes.nodes import Nodes
    from bringup_lint.graph.workspace import Package
    from bringup_lint.model.cpp_source import CppNode
    from bringup_lint.source import Source


def with_header(nodes: Nodes, source: Source) -> str:
    """The text of a file and of those beside it and in the package that are called the same."""
    return "\n".join([source.text, *(each.text for each in _named_alike(nodes, source))])


def headers(nodes: Nodes, source: Source) -> list[CppNode]:
    """The other C++ sources of the package of one that have its name up to the first dot."""
    from bringup_lint.parsers.cpp_node import parse

    return nodes.files.parsed(parse, _named_alike(nodes, source))


def _named_alike(nodes: Nodes, source: Source) -> list[Source]:
    """The other C++ sources of the package of one that have its name up to the first dot, as its header has."""
    return [each for each in _by_stem(nodes).get(_stem(nodes, source), ()) if each is not source]


@kept
def _by_stem(nodes: Nodes) -> dict[tuple[Package | None, str], list[Source]]:
    found: dict[tuple[Package | None, str], list[Source]] = {}
    for source in nodes.files.of_kind("cpp-node", "cpp-driver"):
        found.setdefault(_stem(nodes, source), []).append(source)
    return found


def _stem(nodes: Nodes, source: Source) -> tuple[Package | None, str]:
    return nodes.launch.workspace.owner(source), source.basename.partition(".")[0]
