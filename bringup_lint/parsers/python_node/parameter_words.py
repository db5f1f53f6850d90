"""The texts of a Python file, and whether all names that it declares parameters under are among them."""

from __future__ import annotations

import ast
import re
from collections.abc import Iterator
from functools import cached_property

from bringup_lint.model.parameter_words import LOOSE
from bringup_lint.model.parameter_words import PLAIN
from bringup_lint.model.parameter_words import Asked
from bringup_lint.model.parameter_words import ParameterWords
from bringup_lint.model.python import called_name
from bringup_lint.model.python import children
from bringup_lint.model.python import walk
from bringup_lint.model.python import written
from bringup_lint.parsers.python_syntax import Positions
from bringup_lint.parsers.python_syntax import byte_order_mark
from bringup_lint.parsers.python_syntax import tree_of
from bringup_lint.pattern import regex
from bringup_lint.source import Located
from bringup_lint.source import Source

TEXT = 400_000
"""Code points of a file."""
_READING = ("get_parameter", "get_parameter_or", "has_parameter", "get_parameter_value", "undeclare_parameter")
_OWN = regex(r"(?:self|(?:self\.)?\w*node\w*)\.(?:get_parameter\w*|has_parameter)\Z", re.I)
_TYPE = regex(r"(?:^|\.)Parameter\.Type\.(?!NOT_SET)[A-Z_]+\Z")
_CONTAINERS = (ast.List, ast.Tuple, ast.Dict, ast.Set)
_DECLARING = ("declare_parameter", "declare_parameters")
_HELPER = regex(r"(?=\w+\Z)\w*(?:param|declare)\w*", re.I)
"""The name of a function that may declare parameters for others."""
HELPERS = 3
"""Functions through which the name of a parameter is followed."""


def parse(source: Source) -> ParameterWords:
    """Never raises."""
    tree = tree_of(source) if len(source.text) <= TEXT else None
    if tree is None or LOOSE.search(source.text):
        return ParameterWords(open=True)
    try:
        return _Reader(source, tree).words()
    except RecursionError:
        return ParameterWords(open=True)


class _Reader:
    def __init__(self, source: Source, tree: ast.Module) -> None:
        self.positions = Positions(source, byte_order_mark(source))
        self.nodes = list(walk(tree))
        self.parents = {id(child): node for node in self.nodes for child in children(node)}
        self.calls = [node for node in self.nodes if isinstance(node, ast.Call)]

    def words(self) -> ParameterWords:
        read = {id(call.args[0]) for call in self.calls if call.args and called_name(call) in _READING}
        constants = [node for node in self.nodes if isinstance(node, ast.Constant) and isinstance(node.value, str)]
        used = [node for node in constants if id(node) not in read and not self._is_docstring(node)]
        pieces = (node for node in used if isinstance(self.parents.get(id(node)), (ast.BinOp, ast.JoinedStr)))
        return ParameterWords(
            frozenset(str(node.value) for node in used),
            frozenset(str(node.value) for node in pieces),
            tuple(self._asked()),
            tuple(self._unset()),
            any(self._is_open(call) for call in self.calls),
            declared=self._declared(),
        )

    def _declared(self) -> frozenset[str] | None:
        """The names of the declarations; None where a call makes one of something else than a text, or something else
        than a call gets the function."""
        called = {id(call.func) for call in self.calls}
        if any(
            isinstance(each, ast.Attribute) and each.attr in _DECLARING and id(each) not in called
            for each in self.nodes
        ):
            return None
        found = set()
        for call in self.calls:
            name = called_name(call) or ""
            if name in _DECLARING:
                names = self._names_of(call, name)
                if names is None:
                    return None
                found |= names
            elif _HELPER.fullmatch(name) and not PLAIN.fullmatch(name) and any(map(_has_text, call.args)):
                return None
        return frozenset(found)

    @staticmethod
    def _names_of(call: ast.Call, called: str) -> set[str] | None:
        """What a call declares."""
        names: list[ast.expr | None] = [call.args[0] if call.args else _keyword(call, "name")]
        if called == "declare_parameters":
            space = call.args[0] if call.args else _keyword(call, "namespace")
            given = call.args[1] if len(call.args) > 1 else _keyword(call, "parameters")
            if not isinstance(space, ast.Constant) or space.value or not isinstance(given, (ast.List, ast.Tuple)):
                return None
            names = [each.elts[0] if isinstance(each, ast.Tuple) and each.elts else None for each in given.elts]
        found = {each.value for each in names if isinstance(each, ast.Constant) and isinstance(each.value, str)}
        return found if len(found) == len(set(names)) else None

    def _is_docstring(self, node: ast.Constant) -> bool:
        return isinstance(self.parents.get(id(node)), ast.Expr)

    def _asked(self) -> Iterator[Asked]:
        for call in self.calls:
            name = call.args[0] if call.args else None
            if not isinstance(name, ast.Constant) or not isinstance(name.value, str):
                continue
            if isinstance(call.func, ast.Attribute) and _OWN.match(written(call.func)):
                required = called_name(call) == "get_parameter" and not self._is_tried(call)
                quiet = called_name(call) == "get_parameter_or"
                yield Asked(Located(name.value, self.positions.span(name)), required, quiet)

    def _unset(self) -> Iterator[Located]:
        """What is declared with a type alone and asked for."""
        used = {str(each.name) for each in self._asked() if each.required}
        for call in self.calls:
            if called_name(call) == "declare_parameter" and len(call.args) == 2 and not call.keywords:
                name, kind = call.args
                if not isinstance(name, ast.Constant) or name.value not in used or self._is_tried(call):
                    continue
                if _TYPE.search(written(kind)):
                    yield Located(str(name.value), self.positions.span(name))

    def _is_tried(self, call: ast.Call) -> bool:
        """Whether an exception of the call is handled, or a condition decides about it."""
        node: ast.AST | None = call
        while node is not None and not isinstance(node, (ast.FunctionDef, ast.AsyncFunctionDef)):
            node = self.parents.get(id(node))
            if isinstance(node, (ast.Try, ast.If, ast.IfExp, ast.With)):
                return True
        return False

    def _is_open(self, call: ast.Call) -> bool:
        called = called_name(call)
        if called == "declare_parameters":
            given = call.args[1] if len(call.args) > 1 else _keyword(call, "parameters")
            return given is None or not self._is_container(given)
        if called != "declare_parameter":
            return False
        name = call.args[0] if call.args else _keyword(call, "name")
        return name is None or not self._is_written(name, 0)

    def _is_written(self, node: ast.expr, depth: int) -> bool:
        """Whether a text, a constant, a loop over texts or a helper's caller gives a name."""
        if isinstance(node, ast.Constant):
            return True
        if isinstance(node, (ast.JoinedStr, ast.BinOp)):
            return any(isinstance(each, ast.Constant) and isinstance(each.value, str) for each in ast.walk(node))
        if isinstance(node, ast.Attribute):
            return self._is_constant(written(node)) or node.attr.isupper()
        if not isinstance(node, ast.Name):
            return False
        looped = self._loop_of(node)
        if looped is not None:
            return self._is_container(looped)
        return self._is_constant(node.id) or self._is_of_helper(node, depth)

    def _loop_of(self, node: ast.Name) -> ast.expr | None:
        """What the loop goes through that gives a name its value."""
        outer: ast.AST | None = node
        while outer is not None:
            outer = self.parents.get(id(outer))
            loops = [outer] if isinstance(outer, ast.For) else getattr(outer, "generators", [])
            for loop in loops:
                if any(isinstance(each, ast.Name) and each.id == node.id for each in ast.walk(loop.target)):
                    return loop.iter
        return None

    def _is_container(self, node: ast.expr) -> bool:
        """Whether all that a container holds is written in the file."""
        if isinstance(node, (ast.ListComp, ast.SetComp, ast.GeneratorExp)):
            return all(self._is_container(each.iter) for each in node.generators)
        if isinstance(node, _CONTAINERS):
            return True
        if isinstance(node, ast.Call):
            called = called_name(node)
            if called in ("items", "keys") and isinstance(node.func, ast.Attribute):
                return self._is_container(node.func.value)
            return called in ("enumerate", "sorted", "list", "zip") and all(map(self._is_container, node.args))
        if isinstance(node, (ast.Name, ast.Attribute)):
            values = self._values(written(node))
            return bool(values) and all(isinstance(each, _CONTAINERS) and _has_text(each) for each in values)
        return False

    def _values(self, name: str) -> list[ast.expr]:
        """What is assigned to a variable or attribute anywhere in the file."""
        return self._assigned.get(name, [])

    @cached_property
    def _assigned(self) -> dict[str, list[ast.expr]]:
        found: dict[str, list[ast.expr]] = {}
        for node in self.nodes:
            if isinstance(node, ast.Assign):
                for target in node.targets:
                    found.setdefault(written(target), []).append(node.value)
            elif isinstance(node, ast.AnnAssign) and node.value is not None:
                found.setdefault(written(node.target), []).append(node.value)
        return found

    def _is_constant(self, name: str) -> bool:
        values = self._values(name)
        return bool(values) and all(isinstance(each, ast.Constant) for each in values)

    def _is_of_helper(self, node: ast.Name, depth: int) -> bool:
        """Whether a name is a parameter of the function around it, and every call of that gives a text."""
        outer: ast.AST | None = node
        while outer is not None and not isinstance(outer, (ast.FunctionDef, ast.AsyncFunctionDef)):
            outer = self.parents.get(id(outer))
        if outer is None or depth >= HELPERS:
            return False
        names = [each.arg for each in outer.args.args]
        if node.id not in names:
            return False
        place = names.index(node.id) - (1 if names[0] in ("self", "cls") else 0)
        calls = [call for call in self.calls if called_name(call) == outer.name]
        given = [call.args[place] if len(call.args) > place else _keyword(call, node.id) for call in calls]
        return bool(given) and all(each is not None and self._is_written(each, depth + 1) for each in given)


def _has_text(node: ast.expr) -> bool:
    return any(isinstance(each, ast.Constant) and isinstance(each.value, str) for each in ast.walk(node))


def _keyword(call: ast.Call, name: str) -> ast.expr | None:
    return next((each.value for each in call.keywords if each.arg == name), None)
