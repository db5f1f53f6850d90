"""Parameters that a node of generate_parameter_library has not: one file lists all of its parameters."""

from __future__ import annotations

import os
from collections.abc import Iterator
from typing import TYPE_CHECKING

from bringup_lint.graph.params.questions.unread import MOST
from bringup_lint.graph.params.questions.unread import SURE
from bringup_lint.graph.params.questions.unread import Unread
from bringup_lint.graph.params.questions.unread import own_parameters
from bringup_lint.model.yaml_node import Mapping
from bringup_lint.model.yaml_node import Scalar
from bringup_lint.named_tuple import NamedTuple
from bringup_lint.parsers.yaml_nodes import parse
from bringup_lint.pattern import regex

if TYPE_CHECKING:
    from bringup_lint.graph.launch.launch import Launch
    from bringup_lint.graph.params.params import Params
    from bringup_lint.source import Source
    from bringup_lint.source import Span

_MADE = regex(
    r"\bgenerate_parameter_(?:library\s{0,40}\(\s{0,40}[\w${}-]{1,80}(?:[ \t]{0,20}#[^\n]{0,200})?\s{1,80}"
    r"|module\s{0,4}\(\s{0,40}[\"']\w{1,80}[\"']\s{0,4},\s{0,40}[\"'])(?P<file>[\w./-]{1,200}\.ya?ml)\b",
    hints="generate_parameter_",
)
_MAPPED = "__map_"
"""What begins a level whose name is any of a list that another parameter holds."""


_PATTERNS = 200
"""Names with such levels of one library: with more, none is known to be lacking."""


class _Library(NamedTuple):
    node: str
    names: frozenset[str]
    where: Span
    words: frozenset[str]
    """The parts of the names."""
    mapped: frozenset[tuple[str, ...]]
    """The names of which a level is any of a list; empty there."""

    def has(self, name: str) -> bool:
        if name in self.names or len(self.mapped) > _PATTERNS:
            return True
        parts = name.split(".")
        return any(_fits(each, parts) for each in self.mapped)


def unlisted(params: Params, launch: Launch) -> Iterator[Unread]:
    """Only in blocks that are called as the library, which lists the most of them, and of words that no source has."""
    libraries: dict[str, list[_Library]] = {}
    for each in _libraries(params, launch):
        libraries.setdefault(each.node, []).append(each)
    if not libraries:
        return
    files = (file for file in params.judged if file.accepted and not file.uncertain)
    for file, block in ((each, block) for each in files for block in each.blocks):
        known = libraries.get(block.node_name, [])
        own = own_parameters(block) if len(known) == 1 else []
        lacking = [each for each in own if not known[0].has(str(each.name))]
        count = len(own) - len(lacking)
        left = tuple(each for each in lacking if _is_new(params, known[0], str(each.name)))
        if left and count >= max(SURE, MOST * len(own)):
            yield Unread(file, block, left, known[0].where, count, known[0].names)


def _is_new(params: Params, library: _Library, name: str) -> bool:
    """Whether a part of a name is none of the library, and no text of a source: the node may declare more itself."""
    return any(part not in library.words and not params.is_named_in_code(part) for part in name.split("."))


def _libraries(params: Params, launch: Launch) -> Iterator[_Library]:
    builds = [build.source for package in launch.workspace.packages.values() for build in package.builds]
    paths = (
        os.path.normpath(os.path.join(os.path.dirname(build.absolute), found["file"]))
        for build in builds
        for found in _MADE.finditer(build.text)
    )
    for path in dict.fromkeys(paths):
        source = params.files.tree.read(path, judged=False) if params.files.tree.holds(path) else None
        if source is not None:
            yield from _listed(source)


def _listed(source: Source) -> Iterator[_Library]:
    """The library of one file, whose only key is the name of a node."""
    root = parse(source).root
    if isinstance(root, Mapping):
        for key, value in root.entries:
            names = frozenset(_names(value, ""))
            parts = [name.split(".") for name in names]
            mapped = (tuple("" if part.startswith(_MAPPED) else part for part in each) for each in parts)
            words = frozenset(part for each in parts for part in each)
            yield _Library(str(key.value), names, key.span, words, frozenset(each for each in mapped if "" in each))


def _names(node: object, prefix: str) -> Iterator[str]:
    if not isinstance(node, Mapping):
        return
    if isinstance(node.get("type"), Scalar):
        yield prefix.removesuffix(".")
        return
    for key, value in node.entries:
        yield from _names(value, f"{prefix}{key.value}.")


def _fits(pattern: tuple[str, ...], parts: list[str]) -> bool:
    same = (own in ("", part) for own, part in zip(pattern, parts))
    return len(pattern) == len(parts) and all(same)
