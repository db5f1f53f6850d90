"""Addresses of camera calibrations that camera_info_manager refuses."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from bringup_lint.graph.launch.resolve import text_of
from bringup_lint.graph.launch.started import literal_text
from bringup_lint.graph.workspace import place
from bringup_lint.model.launch_values import TypedValue
from bringup_lint.named_tuple import NamedTuple
from bringup_lint.pattern import regex

if TYPE_CHECKING:
    from bringup_lint.graph.launch.launch import Launch
    from bringup_lint.graph.launch.started import Started
    from bringup_lint.graph.params.params import Params
    from bringup_lint.model.launch_values import Value
    from bringup_lint.source import Span

_NAME = "camera_info_url"
_GOOD = regex(r"(?:file:///|flash:///|package://[^/\s]+/)", hints="://")
"""The beginnings that it understands (camera_info_manager.cpp, parse_url)."""
_READER = "camera_info_manager"


class RefusedUrl(NamedTuple):
    where: Span
    """The value in a parameter file, the name of the parameter in a launch file."""
    given: str
    """The text that is given, or the file of a package that a path leads to."""
    instead: str
    others: tuple[Span, ...] = ()
    """Further parameters that get the same value."""


def refused_urls(launch: Launch, params: Params) -> Iterator[RefusedUrl]:
    """Each value once; not those of nodes of the tree that read the address themselves."""
    found: dict[tuple[str, int], list[RefusedUrl]] = {}
    for value, url, nodes in (*_of_files(params), *_of_launch(launch)):
        if all(_is_read_by_manager(launch, node) for node in nodes):
            found.setdefault((value.path, value.start), []).append(url)
    for first, *more in found.values():
        places = {each.where.start: each.where for each in more if each.where != first.where}
        yield first._replace(others=tuple(places.values()))


def _of_files(params: Params) -> Iterator[tuple[Span, RefusedUrl, list[Started]]]:
    for file, each in params.parameters:
        text = each.value.data
        if str(each.name).rpartition(".")[2] != _NAME or not isinstance(text, str) or "$" in text:
            continue
        if text.strip() and not _GOOD.match(text) and params.is_used(file):
            nodes = [load.node for load in params.loads(file)]
            yield each.span, RefusedUrl(each.span, text, _instead(text)), nodes


def _of_launch(launch: Launch) -> Iterator[tuple[Span, RefusedUrl, list[Started]]]:
    for node in launch.nodes:
        if not node.file.source.judged:
            continue
        for key, value in node.given:
            inner = value.value if isinstance(value, TypedValue) else value
            given = _refused(inner) if text_of(key) == _NAME else None
            if given is not None:
                yield inner.span, RefusedUrl(key.span, *given), [node]


def _refused(value: Value) -> tuple[str, str] | None:
    """What is given and what to write instead, where that is not an address."""
    text = literal_text(value)
    if text is not None:
        is_wrong = bool(text.strip()) and not _GOOD.match(text) and "$" not in text
        return (str(text), _instead(text)) if is_wrong else None
    where = place(value)
    if where is None or where.base not in ("share", "prefix", "file"):
        return None
    return f"the path of {where.path.rpartition('/')[2]}", "'file://' before the path"


def _instead(text: str) -> str:
    if text.startswith("/"):
        return f"file://{text}"
    return f"file:///{text[7:]}" if text.startswith("file://") else "file:// and an absolute path"


def _is_read_by_manager(launch: Launch, node: Started) -> bool:
    """Whether a node is one of a public package, or one whose package uses camera_info_manager."""
    package = launch.workspace.packages.get(str(literal_text(node.package)))
    return package is None or any(_READER in str(name) for _, name in package.manifest.depends)
