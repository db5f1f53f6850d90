"""Lists of nodes that something watches or waits for, against the names of the nodes that are started."""

from __future__ import annotations

import ast
import re
from collections import Counter
from collections.abc import Callable
from collections.abc import Iterator
from typing import TYPE_CHECKING

from bringup_lint.dataclass import dataclass
from bringup_lint.discover.starters import STARTING
from bringup_lint.graph.topics.resolved.node_names import NodeNames
from bringup_lint.model.node_source import NodeSource
from bringup_lint.named_tuple import NamedTuple
from bringup_lint.pattern import regex
from bringup_lint.source import Located
from bringup_lint.source import Source
from bringup_lint.source import Span
from bringup_lint.spelling import nearest

if TYPE_CHECKING:
    from bringup_lint.graph.files import Files
    from bringup_lint.graph.nodes.nodes import Nodes
    from bringup_lint.graph.params.params import Params

LIST = regex(
    r"(?:\w+[._])?(?:monitor|watch|expect|requir|critical|supervis|heartbeat|essential|mandatory)\w{0,64}?_?nodes?(?:_names|_list)?"
    r"|nodes?_(?:names_)?to_(?:monitor|watch|check|supervise|wait_for)",
    re.I,
)
"""Names of lists of nodes."""
_GREP = regex(
    r"ros2\s+node\s+list[^|\n;&]*\|\s*grep(?P<options>(?:\s+-\w+)*)\s+(?P<quote>[\"']?)(?P<name>/?[A-Za-z]\w*(?:/\w+)*)(?P=quote)(?=[\s;&|)]|$)"
)
_NAME = regex(r"/?[A-Za-z_]\w*(?:/\w+)*")
SHORTEST = 4


class Watched(NamedTuple):
    names: list[Located]
    whole: bool
    """The name is compared as a whole; else it is looked for inside names, as ``grep`` does."""
    where: Located
    """What the list is called, or the name itself."""


@dataclass(frozen=True, eq=False)
class WatchLists:
    """Where lists of nodes are written. ``given``: the names of the parameters that launch files give to the nodes of a
    source."""

    files: Files
    nodes: Nodes
    params: Callable[[], Params]
    given: Callable[[Source], set[str]]

    def all(self) -> Iterator[Watched]:
        """Every list of nodes in Python sources, parameter files and the files of runners."""
        for file in self.nodes.judged:
            if self.nodes.is_for_robot(file.source):
                given = self.given(file.source)
                yield from (found for found in _of_python(file) if str(found.where) not in given)
        yield from self._of_params()
        for source in self.files.of_kind(*sorted(STARTING)):
            if source.judged and not source.template and "node" in source.text:
                yield from _of_script(source)

    def _of_params(self) -> Iterator[Watched]:
        params = self.params()
        for _, parameter in params.parameters:
            if LIST.fullmatch(parameter.name.rpartition(".")[2]) and parameter.value.type == "string_array":
                names = [_unquoted(item.text, item.span) for item in params.items(parameter)]
                if names:
                    yield Watched(names, True, parameter.key)


def _unquoted(text: str, span: Span) -> Located:
    """A literal without the quotes around it."""
    at = span.text.find(text)
    return span.source.located(span.start + at, span.start + at + len(text)) if at >= 0 else Located(text, span)


def _of_python(file: NodeSource) -> Iterator[Watched]:
    for node in file.nodes:
        if isinstance(node, ast.Assign) and len(node.targets) == 1:
            target = node.targets[0]
            name = (
                target.id if isinstance(target, ast.Name) else target.attr if isinstance(target, ast.Attribute) else ""
            )
            yield from _list(file, name, node.value, target)
        elif isinstance(node, ast.Call) and isinstance(node.func, ast.Attribute):
            if node.func.attr == "declare_parameter" and len(node.args) > 1 and isinstance(node.args[0], ast.Constant):
                yield from _list(file, str(node.args[0].value), node.args[1], node.args[0])


def _list(file: NodeSource, name: str, value: ast.expr, where: ast.expr) -> Iterator[Watched]:
    if not LIST.fullmatch(name.rpartition(".")[2]):
        return
    items = value.keys if isinstance(value, ast.Dict) else getattr(value, "elts", [])
    texts = [item for item in items if isinstance(item, ast.Constant) and isinstance(item.value, str)]
    names = [_unquoted(str(item.value), file.span_of(item)) for item in texts]
    if names and len(names) == len(items):
        span = file.span_of(where)
        yield Watched(names, True, Located(name, span))


def _of_script(source: Source) -> Iterator[Watched]:
    for found in _GREP.finditer(source.text):
        line = source.text.rfind("\n", 0, found.start()) + 1
        if "#" not in source.text[line : found.start()] and "v" not in found["options"] and "E" not in found["options"]:
            name = source.located(*found.span("name"))
            yield Watched([name], "x" in found["options"], name)


class Missing(NamedTuple):
    name: Located
    """Of no node."""
    list: Watched
    meant: str | None
    """The node that is probably meant."""
    is_typo: bool
    """More places have the name of that node, so that this one is wrong, and not the one that starts it."""


def missing(found: Watched, names: NodeNames, naming: Counter[str]) -> Iterator[Missing]:
    """The names of a list that no node has. Where none of them is the name of a node, or nearly so, the list is one of
    something else. With nodes of public packages beside the known ones, only what is nearly the name of a node.
    ``naming`` counts the places that call a node so."""
    if names.open:
        return
    full = sorted(names.known)
    bare = {name.rpartition("/")[2] for name in full}
    lost = [name for name in found.names if _NAME.fullmatch(name) and not _is_there(name, found.whole, full, bare)]
    meant = {str(name): _meant(str(name), bare) for name in lost}
    if len(lost) == len(found.names) and not any(meant.values()):
        return
    for name in lost:
        near = meant[str(name)]
        if names.may_be(name) or (names.public and near is None):
            continue
        yield Missing(name, found, near, near is not None and naming[near] > naming[name.rpartition("/")[2]])


def _is_there(name: str, whole: bool, full: list[str], bare: set[str]) -> bool:
    if not whole:
        return any(name in each for each in full)
    return name in bare or name in full or f"/{name}" in full


def _meant(name: str, bare: set[str]) -> str | None:
    own = name.rpartition("/")[2]
    near = nearest(own, sorted(bare))
    if not near:
        near = [each for each in sorted(bare) if min(len(each), len(own)) >= SHORTEST and (each in own or own in each)]
    return near[0] if len(near) == 1 else None
