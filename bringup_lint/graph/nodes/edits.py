"""Changes of node sources: imports that a fix needs."""

from __future__ import annotations

import ast

from bringup_lint.finding import Edit
from bringup_lint.finding import Fix
from bringup_lint.graph.nodes.sources.ending import Ending
from bringup_lint.model.node_source import NodeSource
from bringup_lint.source import Span


def import_edits(file: NodeSource, module: str, name: str) -> list[tuple[Span, str]]:
    """The edit that imports a name, or the module of that name; none when the file has it."""
    if file.imports.get(name) in (f"{module}.{name}", module or name):
        return []
    body = file.tree.body if file.tree is not None else []
    imports = [node for node in body if isinstance(node, (ast.Import, ast.ImportFrom))]
    ours = [node for node in imports if _sorts_before(node, module)]
    line = f"from {module} import {name}\n" if module else f"import {name}\n"
    if ours:
        return [(_line_after(file, ours[-1]), line)]
    first = imports[0] if imports else next(iter(body), None)
    start = file.span_of(first).start if first is not None else 0
    return [(Span(file.source, start, start), line)]


def tried_shutdown(ending: Ending, call: ast.Call) -> list[tuple[Span, str]]:
    """The edit that makes ``rclpy.try_shutdown()`` of ``rclpy.shutdown()``; none for the bare imported function."""
    name = ending.file.span_of(call.func)
    return [(name, f"{name.text[: -len('shutdown')]}try_shutdown")] if name.text.endswith(".shutdown") else []


def swap(file: NodeSource, first: ast.stmt, second: ast.stmt) -> Fix | None:
    """Move a statement after a later one of its block; None when either shares a line, or gives a value."""
    if not isinstance(first, ast.Expr) or not isinstance(second, ast.Expr):
        return None
    upper, lower = _lines(file, first), _lines(file, second)
    if upper is None or lower is None:
        return None
    after = Span(file.source, lower.end, lower.end)
    edits = (Edit(upper, ""), Edit(after, upper.text))
    return (
        Fix("publish first, then deactivate", edits) if upper.text.endswith("\n") == lower.text.endswith("\n") else None
    )


def _lines(file: NodeSource, node: ast.stmt) -> Span | None:
    """The whole lines of a statement; None when something else is on them."""
    span, text = file.span_of(node), file.source.text
    start = text.rfind("\n", 0, span.start) + 1
    end = text.find("\n", span.end)
    end = len(text) if end < 0 else end + 1
    alone = not text[start : span.start].strip() and not text[span.end : end].strip()
    return Span(file.source, start, end) if alone else None


def _sorts_before(node: ast.Import | ast.ImportFrom, module: str) -> bool:
    """Whether an import of the same package is before one of the module in the order of the alphabet."""
    root = module.partition(".")[0]
    if isinstance(node, ast.Import):
        return any(each.name.partition(".")[0] == root for each in node.names)
    return not node.level and (node.module or "").partition(".")[0] == root and (node.module or "") <= module


def _line_after(file: NodeSource, node: ast.stmt) -> Span:
    """The start of the line after a statement."""
    end = file.source.text.find("\n", file.span_of(node).end)
    at = len(file.source.text) if end < 0 else end + 1
    return Span(file.source, at, at)
