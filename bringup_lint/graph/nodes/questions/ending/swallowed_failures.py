"""Programs that take what a spin raises, and end as if all had gone well."""

from __future__ import annotations

import ast
import sys
from collections.abc import Iterator
from typing import TYPE_CHECKING

from bringup_lint.graph.nodes.resolved.starting import is_tool
from bringup_lint.graph.nodes.sources.age import COMMENTS
from bringup_lint.graph.nodes.sources.ending import Ending
from bringup_lint.model.cpp_source import Swallowed
from bringup_lint.model.python import walk
from bringup_lint.pattern import regex

if TYPE_CHECKING:
    from bringup_lint.graph.nodes.nodes import Nodes

_FAILS = regex(r"exit\s{0,4}\((?!\s{0,4}main\()|\b(?:abort|quit|kill|exec[lv]\w{0,3})\s{0,4}\(|\bSystemExit\b")
"""What may end a program with another status, anywhere in its source."""
_GOES_ON = (ast.Raise, ast.Return, ast.Assign, ast.AugAssign, ast.AnnAssign, ast.Continue, ast.Break)
_ROOTS = ("rclpy", "self", "cv2", "numpy", "serial")
"""Packages that end no program."""
_ALL = frozenset({"Exception", "BaseException"})


def swallowed_failures(nodes: Nodes) -> Iterator[list[Swallowed]]:
    """Those of one source together, where only ``main`` spins and returns nothing but 0."""
    for file in nodes.robot_sources:
        if not is_tool(nodes, file) and not _FAILS.search(COMMENTS.sub("", file.source.text)):
            found = list(_in_file(nodes.ending(file)))
            if found:
                yield found
    for source in nodes.cpp:
        if source.swallowed:
            yield source.swallowed


def _in_file(ending: Ending) -> Iterator[Swallowed]:
    for node, spins in ending.tries:
        function = ending.syntax.function(node)
        if function is None or function.name != "main" or _is_tried_again(ending, node) or _returns(function):
            continue
        for handler in node.handlers:
            inside = list(_inside(handler))
            if any(isinstance(each, _GOES_ON) or _is_unknown(ending, each) for each in inside):
                continue
            if ending.caught(handler) & _ALL:
                place = ending.file.span_of(handler.type or handler)
                yield Swallowed(place, ending.file.span_of(spins[0].call))


def _inside(handler: ast.ExceptHandler) -> Iterator[ast.AST]:
    return (each for statement in handler.body for each in walk(statement))


def _is_unknown(ending: Ending, node: ast.AST) -> bool:
    """Whether something is called that another file of the robot has, which may end the program."""
    name = ending.syntax.qualified(node) if isinstance(node, ast.Call) else None
    root = (name or "").partition(".")[0]
    return "." in (name or "") and root not in _ROOTS and root not in sys.stdlib_module_names


def _is_tried_again(ending: Ending, node: ast.AST) -> bool:
    """Whether a loop tries again."""
    return any(isinstance(outer, (ast.While, ast.For)) for outer, _ in ending.syntax.within(node))


def _returns(function: ast.AST) -> bool:
    """Whether a function gives a value back, which may be the status."""
    return any(isinstance(each, ast.Return) and each.value is not None for each in walk(function))
