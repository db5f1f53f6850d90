"""Readings that take the frame of the message they are made of, and the time of now."""

from __future__ import annotations

import ast
from collections.abc import Iterator
from typing import TYPE_CHECKING

from bringup_lint.graph.nodes.sources.with_header import with_header
from bringup_lint.model.node_source import DERIVED
from bringup_lint.model.node_source import MEASURED
from bringup_lint.model.python import FunctionNode
from bringup_lint.model.python import written
from bringup_lint.named_tuple import NamedTuple
from bringup_lint.parsers.cpp_node.restamped import INTENDED
from bringup_lint.pattern import regex
from bringup_lint.source import Source
from bringup_lint.source import Span

if TYPE_CHECKING:
    from bringup_lint.graph.nodes.nodes import Nodes
    from bringup_lint.model.node_source import NodeSource

_NOW = regex(r"\bnow\(\)(?:\.to_msg\(\))?\Z")
_CHOICES = (ast.If, ast.IfExp, ast.Match, ast.FunctionDef, ast.Lambda)


class Replaced(NamedTuple):
    source: Source
    stamped: Span
    frame: Span
    name: str
    message: str


def restamped(nodes: Nodes) -> Iterator[Replaced]:
    for file in nodes.robot_sources:
        if "frame_id" in file.source.text and not INTENDED.search(file.source.text):
            yield from _in_python(file)
    for node in nodes.cpp:
        if node.restamped and not INTENDED.search(with_header(nodes, node.source)):
            for each in node.restamped:
                yield Replaced(node.source, each.stamped, each.frame, each.name, each.message)


def _in_python(file: NodeSource) -> Iterator[Replaced]:
    for cls in file.classes:
        for endpoint in cls.endpoints:
            kind = (endpoint.type or "").rpartition("/")[2]
            method = cls.methods.get(endpoint.callback or "")
            if endpoint.role == "subscription" and kind in MEASURED and method is not None and method.node.args.args:
                yield from _in_callback(file, method.node, kind)


def _in_callback(file: NodeSource, function: FunctionNode, kind: str) -> Iterator[Replaced]:
    """Each name that a callback sets both fields of, where no condition decides about them."""
    message = function.args.args[-1].arg
    made: dict[str, str] = {message: kind}
    stamps: dict[str, ast.Assign] = {}
    frames: dict[str, ast.Assign] = {}
    for each in _assignments(function):
        target, value = written(each.targets[0]), written(each.value)
        if isinstance(each.targets[0], ast.Name):
            called = value.partition("(")[0].rpartition(".")[2] if isinstance(each.value, ast.Call) else ""
            made[target] = kind if value == message else called
        elif target.endswith(".header.stamp") and _NOW.search(value):
            stamps[target.removesuffix(".header.stamp")] = each
        elif target.endswith(".header.frame_id") and value == f"{message}.header.frame_id":
            frames[target.removesuffix(".header.frame_id")] = each
    for name, stamp in stamps.items():
        if name in frames and made.get(name) in DERIVED:
            yield Replaced(file.source, file.span_of(stamp), file.span_of(frames[name]), name, message)


def _assignments(function: ast.AST) -> Iterator[ast.Assign]:
    """Those that each run of a function or of its loops reaches, in the order of the text."""
    for each in ast.iter_child_nodes(function):
        if isinstance(each, ast.Assign):
            yield each
        elif not isinstance(each, _CHOICES):
            yield from _assignments(each)
