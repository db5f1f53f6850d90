"""The paths that a Python module computes from its own place."""

from __future__ import annotations

import ast
import os
from collections.abc import Iterator

from bringup_lint.model.python import called_name
from bringup_lint.model.python import dotted_name
from bringup_lint.source import Source

_SAME = ("abspath", "realpath", "normpath", "fspath", "Path", "PurePath", "str")
"""Functions that give the path that they are given."""
_DEEPEST = 40
"""Steps in which a path is computed."""
_METHODS = ("resolve", "absolute", "as_posix")
_ASKS = frozenset(
    "exists isfile isdir is_file is_dir glob rglob mkdir makedirs insert append save savefig savetxt savez imwrite"
    " to_csv write_text write_bytes touch".split()
)
"""What asks first whether a file is there or makes it, and what lengthens the path of modules."""
_TESTS = frozenset("exists isfile isdir is_file is_dir".split())
_DEFAULTS = frozenset("declare_parameter add_argument get getenv".split())
"""What gives a value where nobody gives another one, by the name that is its first argument."""


class OwnPaths:
    """The paths that a module computes from its own place: ``__file__``, and what is made of it."""

    def __init__(self, source: Source, syntax: ast.Module) -> None:
        self._file = source.absolute
        self._variables: dict[str, str] = {}
        self.outermost: list[ast.expr] = []
        """The expressions that may be such paths, no parts of others, in any order."""
        self.asked: set[str] = set()
        """The paths of which the module asks whether they are there, or that it makes."""
        self.defaults: dict[str, list[str]] = {}
        """The names of parameters, options and variables of which a path is the default."""
        self._flask = _has_flask(syntax)
        nodes = list(_run_when_imported(syntax))
        for node in nodes:
            if isinstance(node, ast.Assign) and isinstance(node.targets[0], (ast.Name, ast.Attribute)):
                value = self.value(node.value)
                name = dotted_name(node.targets[0])
                if value is not None and name:
                    self._variables[name] = value
        self._collect(nodes)
        self._excuse(syntax, nodes)

    def _collect(self, nodes: list[ast.AST]) -> None:
        parts: set[int] = set()
        for node in nodes:
            if not isinstance(node, (ast.Call, ast.BinOp, ast.JoinedStr)):
                continue
            if isinstance(node, ast.Call) and (called_name(node) in _ASKS or _writes(node)):
                given = [*node.args, *([node.func.value] if isinstance(node.func, ast.Attribute) else [])]
                self.asked.update(path for each in given if (path := self.value(each)) is not None)
            if id(node) in parts:
                parts.update(map(id, ast.iter_child_nodes(node)))
            elif self.value(node) is not None:
                self.outermost.append(node)
                parts.update(map(id, ast.walk(node)))

    def _excuse(self, syntax: ast.Module, nodes: list[ast.AST]) -> None:
        """Adds what one of several places, or a function of the module, may test before, and what nothing reads, but
        for the constants of the module, which others may import."""
        names = (each for each in ast.walk(syntax) if isinstance(each, ast.Name))
        read = {each.id for each in names if isinstance(each.ctx, ast.Load)}
        constants = set(map(id, syntax.body))
        has_test = any(isinstance(each, ast.Call) and called_name(each) in _TESTS for each in nodes)
        own = {each.name for each in nodes if isinstance(each, ast.FunctionDef)} if has_test else set()
        for node in nodes:
            tested: list[ast.expr] = []
            if isinstance(node, (ast.List, ast.Tuple)) and has_test:
                tested = node.elts
            elif isinstance(node, ast.Assign) and id(node) not in constants:
                is_read = any(not isinstance(each, ast.Name) or each.id in read for each in node.targets)
                tested = [] if is_read else [node.value]
            elif isinstance(node, ast.Call):
                tested = node.args if called_name(node) in own else []
                self._note_default(node)
            self.asked.update(path for each in tested if (path := self.value(each)) is not None)

    def _note_default(self, call: ast.Call) -> None:
        name = self._text(call.args[0]) if call.args and called_name(call) in _DEFAULTS else None
        if name is None:
            return
        for each in (*call.args[1:], *(each.value for each in call.keywords)):
            path = self.value(each)
            if path is not None:
                self.defaults.setdefault(path, []).append(name.lstrip("-"))

    def value(self, node: ast.expr, depth: int = 0) -> str | None:
        """An absolute path; None of everything else."""
        inner = depth + 1
        if inner > _DEEPEST:
            return None
        if isinstance(node, (ast.Name, ast.Attribute)):
            if isinstance(node, ast.Name) and node.id == "__file__":
                return self._file
            known = self._variables.get(dotted_name(node))
            above = self.value(node.value, inner) if isinstance(node, ast.Attribute) and node.attr == "parent" else None
            return os.path.dirname(above) if above is not None else known
        if isinstance(node, ast.Subscript):
            return self._above(node, inner)
        if isinstance(node, ast.BinOp):
            return self._joined(node.op, self.value(node.left, inner), self._text(node.right))
        if isinstance(node, ast.JoinedStr):
            return self._format(node, inner)
        return self._called(node, inner) if isinstance(node, ast.Call) else None

    def _above(self, node: ast.Subscript, depth: int) -> str | None:
        """``Path(...).parents[1]``."""
        number = node.slice.value if isinstance(node.slice, ast.Constant) else None
        is_parents = isinstance(node.value, ast.Attribute) and node.value.attr == "parents"
        path = self.value(node.value.value, depth) if isinstance(node.value, ast.Attribute) and is_parents else None
        if path is None or not isinstance(number, int) or number >= path.count("/"):
            return None
        for _ in range(number + 1):
            path = os.path.dirname(path)
        return path

    @staticmethod
    def _joined(operator: ast.operator, path: str | None, more: str | None) -> str | None:
        if path is None or more is None:
            return None
        if isinstance(operator, ast.Div):
            return os.path.normpath(os.path.join(path, more))
        return os.path.normpath(path + more) if isinstance(operator, ast.Add) else None

    def _format(self, node: ast.JoinedStr, depth: int) -> str | None:
        first, *others = node.values or [node]
        path = self.value(first.value, depth) if isinstance(first, ast.FormattedValue) else None
        texts = [str(each.value) for each in others if isinstance(each, ast.Constant)]
        return os.path.normpath(path + "".join(texts)) if path is not None and len(texts) == len(others) else None

    def _called(self, node: ast.Call, depth: int) -> str | None:
        name = called_name(node)
        if name == "render_template" and self._flask and node.args:
            template = self._text(node.args[0])
            return template and os.path.join(os.path.dirname(self._file), "templates", template)
        if name in _METHODS and isinstance(node.func, ast.Attribute):
            return self.value(node.func.value, depth)
        parts = [*node.args]
        if name == "joinpath" and isinstance(node.func, ast.Attribute):
            parts.insert(0, node.func.value)
        path = self.value(parts[0], depth) if parts else None
        if path is None or (name in _SAME and len(parts) == 1):
            return path
        if name == "dirname":
            return os.path.dirname(path)
        more = [self._text(each) for each in parts[1:]]
        known = [each for each in more if each is not None]
        is_path = name in ("join", "joinpath", *_SAME) and len(known) == len(more)
        return os.path.normpath(os.path.join(path, *known)) if is_path else None

    @staticmethod
    def _text(node: ast.expr) -> str | None:
        if isinstance(node, ast.Attribute) and node.attr == "pardir":
            return ".."
        return node.value if isinstance(node, ast.Constant) and isinstance(node.value, str) else None


def _writes(call: ast.Call) -> bool:
    """Whether a file is opened for more than to read it."""
    modes = [*call.args[1:2], *(each.value for each in call.keywords if each.arg == "mode")]
    given = "".join(str(each.value) for each in modes if isinstance(each, ast.Constant))
    return called_name(call) == "open" and not set("wax").isdisjoint(given)


def _has_flask(syntax: ast.Module) -> bool:
    """Whether a module makes a web server that looks for its templates beside it."""
    return any(
        isinstance(node, ast.Call)
        and called_name(node) == "Flask"
        and {each.arg for each in node.keywords}.isdisjoint(("template_folder", "root_path", None))
        for node in ast.walk(syntax)
    )


def _run_when_imported(syntax: ast.Module) -> Iterator[ast.AST]:
    """All nodes in the order of the text, outer ones first, but for ``try`` and what runs only as a script."""
    todo: list[ast.AST] = [syntax]
    while todo:
        node = todo.pop()
        is_main = isinstance(node, ast.If) and any(dotted_name(each) == "__name__" for each in ast.walk(node.test))
        if not is_main and not (isinstance(node, ast.Try) and node.handlers):
            yield node
            todo.extend(reversed(list(ast.iter_child_nodes(node))))
