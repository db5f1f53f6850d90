"""Methods of nodes that look whether commands still arrive, and that nothing calls."""

from __future__ import annotations

import ast
import re
from collections.abc import Iterator
from typing import TYPE_CHECKING

from bringup_lint.model.python import walk
from bringup_lint.parsers.python_node.classes import ROOTS
from bringup_lint.pattern import regex

if TYPE_CHECKING:
    from bringup_lint.graph.nodes.nodes import Nodes
    from bringup_lint.model.node_source import Function
    from bringup_lint.model.node_source import NodeClass
    from bringup_lint.model.node_source import NodeSource
    from bringup_lint.source import Source

_CHECKS = regex(
    r"(?:\w{1,40}_)?(?:watchdog|dead_?man|fail_?safe)(?:_\w{1,40})?\Z"
    r"|(?:\w{1,40}_)?time_?out_(?:check|cb|callback|timer)\Z|_?check_(?:\w{1,40}_)?time_?outs?\Z",
    re.I,
)
_MENTIONED = regex(r"(?i)watchdog|dead_?man|fail_?safe|time_?out")
_WORD = regex(r"\w+")
_OTHERS = regex(
    r"_{0,2}(?:get|set|is|has|feed|kick|pet|reset|enable|disable|start|stop|make|create|init|setup"
    r"|trigger|engage|activate|clear|release|exit|enter|cancel|arm|disarm|on|handle)_"
)
"""How methods begin that look for nothing."""


def unrun_checks(nodes: Nodes) -> Iterator[tuple[NodeSource, NodeClass, Function]]:
    """Of classes of which the tree has all that they build on, and where no other file of the tree has the name."""
    unnamed: list[tuple[NodeSource, NodeClass, Function, str]] = []
    named: dict[int, set[object]] = {}
    for file, node in nodes.node_classes:
        if not all(base in ROOTS for base in node.bases) or "getattr(" in file.source.text:
            continue
        for name, method in node.methods.items():
            if _CHECKS.match(name) and not _OTHERS.match(name) and _looks(method):
                if id(file) not in named:
                    named[id(file)] = set(_named(file))
                if name not in named[id(file)]:
                    unnamed.append((file, node, method, name))
    texts = _texts(nodes, {name for *_, name in unnamed})
    for file, node, method, name in unnamed:
        if texts[name] <= {file.source}:
            yield file, node, method


def _looks(method: Function) -> bool:
    """Whether a method takes nothing and decides something."""
    given = method.node.args
    alone = len(given.args) == 1 and not (given.kwonlyargs or given.vararg or given.kwarg)
    return alone and not method.decorators and any(isinstance(each, ast.If) for each in walk(method.node))


def _named(file: NodeSource) -> Iterator[object]:
    """What the code of a file may mean methods with."""
    for each in file.nodes:
        if isinstance(each, ast.Attribute):
            yield each.attr
        elif isinstance(each, ast.Constant):
            yield each.value


def _texts(nodes: Nodes, names: set[str]) -> dict[str, set[Source]]:
    """The files of the tree whose text has a name."""
    found: dict[str, set[Source]] = {name: set() for name in names}
    if not names:
        return found
    for source in nodes.files.sources:
        if _MENTIONED.search(source.text):
            for name in names.intersection(_WORD.findall(source.text)):
                found[name].add(source)
    return found
