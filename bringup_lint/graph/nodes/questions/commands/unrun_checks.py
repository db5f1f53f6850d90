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

_CHECKS = regex(
    r"(?:\w{1,40}_)?(?:watchdog|dead_?man|fail_?safe)(?:_\w{1,40})?\Z"
    r"|(?:\w{1,40}_)?time_?out_(?:check|cb|callback|timer)\Z|_?check_(?:\w{1,40}_)?time_?outs?\Z",
    re.I,
)
_OTHERS = regex(
    r"_{0,2}(?:get|set|is|has|feed|kick|pet|reset|enable|disable|start|stop|make|create|init|setup"
    r"|trigger|engage|activate|clear|release|exit|enter|cancel|arm|disarm|on|handle)_"
)
"""How methods begin that look for nothing."""


def unrun_checks(nodes: Nodes) -> Iterator[tuple[NodeSource, NodeClass, Function]]:
    """Of classes of which the tree has all that they build on, and where no other file of the tree has the name."""
    for file, node in nodes.node_classes:
        if not all(base in ROOTS for base in node.bases) or "getattr(" in file.source.text:
            continue
        for name, method in node.methods.items():
            if _CHECKS.match(name) and not _OTHERS.match(name) and _looks(method) and not _is_named(nodes, file, name):
                yield file, node, method


def _looks(method: Function) -> bool:
    """Whether a method takes nothing and decides something."""
    given = method.node.args
    alone = len(given.args) == 1 and not (given.kwonlyargs or given.vararg or given.kwarg)
    return alone and not method.decorators and any(isinstance(each, ast.If) for each in walk(method.node))


def _is_named(nodes: Nodes, file: NodeSource, name: str) -> bool:
    """Whether the code of the file mentions a method, or the text of another file does."""
    for each in file.nodes:
        if isinstance(each, ast.Attribute) and each.attr == name:
            return True
        if isinstance(each, ast.Constant) and each.value == name:
            return True
    word = re.compile(rf"\b{re.escape(name)}\b")
    others = (each.text for each in nodes.files.sources if each is not file.source)
    return any(name in text and word.search(text) is not None for text in others)
