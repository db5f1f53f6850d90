"""An import that a change needs: among those of its package, in their order, after the docstring and ``__future__``."""

from __future__ import annotations

import ast
import io
from bisect import bisect

from bringup_lint.model.python import syntax_of
from bringup_lint.named_tuple import NamedTuple


class Import(NamedTuple):
    """``from module import name``."""

    module: str
    name: str


def with_import(text: str, wanted: Import) -> str:
    """The text of a module that imports a name at its top; as it is where it does so already, or is not Python."""
    tree = syntax_of(text)
    if tree is None or _imports(tree, wanted):
        return text
    same = [each for each in _froms(tree) if each.module == wanted.module and each.names[0].name != "*"]
    if same:
        return _named(text, same[-1], wanted.name)
    newline = "\r\n" if "\r\n" in text else "\n"
    line, is_last = _place(tree, wanted)
    lines = _lines(text)
    blank = newline if is_last and "".join(lines[line : line + 1]).strip() else ""
    if line and not lines[line - 1].endswith("\n"):
        lines[line - 1] += newline
    lines.insert(line, f"from {wanted.module} import {wanted.name}{newline}{blank}")
    return "".join(lines)


def _lines(text: str) -> list[str]:
    """The lines as Python counts them, with their ends."""
    return io.StringIO(text, newline="").readlines()


def _froms(tree: ast.Module) -> list[ast.ImportFrom]:
    return [each for each in tree.body if isinstance(each, ast.ImportFrom) and not each.level]


def _imports(tree: ast.Module, wanted: Import) -> bool:
    names = (name for each in _froms(tree) if each.module == wanted.module for name in each.names)
    return any(name.name == "*" or (name.name == wanted.name and name.asname is None) for name in names)


def _named(text: str, statement: ast.ImportFrom, name: str) -> str:
    """The text with one more name in a statement: in its order where it has one, else at the end."""
    names = [each.name for each in statement.names]
    at = bisect(names, name) if names == sorted(names) else len(names)
    is_last = at == len(names)
    alias = statement.names[at - 1 if is_last else at]
    lines = _lines(text)
    blank = _blank_before(lines[alias.lineno - 1], alias.col_offset)
    line, column = (alias.end_lineno, alias.end_col_offset) if is_last else (alias.lineno, alias.col_offset)
    data = lines[(line or 1) - 1].encode()
    added = f",{blank}{name}" if is_last else f"{name},{blank}"
    lines[(line or 1) - 1] = (data[:column] + added.encode() + data[column:]).decode()
    return "".join(lines)


def _blank_before(line: str, column: int) -> str:
    """What parts a name from the one before: a line end and its indentation where each has a line of its own."""
    before = line.encode()[:column].decode()
    if before.strip():
        return " "
    return ("\r\n" if line.endswith("\r\n") else "\n") + before


def _place(tree: ast.Module, wanted: Import) -> tuple[int, bool]:
    """The line after which a new statement is written, and whether it is the last of the imports there."""
    head = _head(tree)
    package = wanted.module.partition(".")[0]
    related = [each for each in head if _module(each).partition(".")[0] == package]
    before = [each for each in related if _module(each) <= wanted.module]
    if related and not before:
        return related[0].lineno - 1, False
    if before or head:
        last = (before or head)[-1]
        return _below(tree, last), last is head[-1]
    first = next((each for each in tree.body if not _is_docstring(each)), None)
    if first is None:
        return (tree.body[-1].end_lineno or 0) if tree.body else 0, False
    decorated = getattr(first, "decorator_list", [])
    return min(each.lineno for each in (first, *decorated)) - 1, True


def _below(tree: ast.Module, statement: ast.stmt) -> int:
    """The last line of a statement, and of those that begin on it."""
    line = statement.lineno
    for each in tree.body:
        if each.lineno <= line:
            line = max(line, each.end_lineno or line)
    return line


def _head(tree: ast.Module) -> list[ast.Import | ast.ImportFrom]:
    """The imports before everything else."""
    found: list[ast.Import | ast.ImportFrom] = []
    for each in tree.body:
        if isinstance(each, (ast.Import, ast.ImportFrom)):
            found.append(each)
        elif not _is_docstring(each):
            break
    return found


def _module(each: ast.Import | ast.ImportFrom) -> str:
    return (each.module or "") if isinstance(each, ast.ImportFrom) else each.names[0].name


def _is_docstring(each: ast.stmt) -> bool:
    return isinstance(each, ast.Expr) and isinstance(each.value, ast.Constant)
