"""Where in a node source a piece of syntax is: its statement, block and function."""

from __future__ import annotations

import ast
from collections.abc import Callable
from collections.abc import Iterable
from collections.abc import Iterator
from collections.abc import Mapping
from functools import cached_property
from typing import Any
from typing import TypeVar

from bringup_lint.model.node_source import NodeClass
from bringup_lint.model.node_source import NodeSource
from bringup_lint.model.python import FunctionNode
from bringup_lint.model.python import children
from bringup_lint.model.python import fields_of
from bringup_lint.model.python import is_own

Answer = TypeVar("Answer")
_ENDS = (ast.Return, ast.Raise, ast.Break, ast.Continue)
"""Statements after which nothing of their block runs."""
FUNCTIONS = (ast.FunctionDef, ast.AsyncFunctionDef, ast.Lambda)
COMPREHENSIONS = (ast.ListComp, ast.SetComp, ast.DictComp, ast.GeneratorExp)


class Syntax:
    """The tree of one file, read upwards."""

    def __init__(self, file: NodeSource) -> None:
        self.file = file
        self.calls: list[ast.Call] = []
        self.reached: dict[tuple[object, ...], list[ast.AST]] = {}
        """A class and statements of it -> the syntax that these run, in one run: other files have a part in it."""
        self._made: dict[Callable[[Syntax], Any], Any] = {}
        self._qualified: dict[ast.Call, str | None] = {}
        self._above: dict[ast.AST, tuple[ast.AST, str]] = {}
        stack: list[ast.AST] = [file.tree] if file.tree is not None else []
        while stack:
            node = stack.pop()
            if isinstance(node, ast.Call):
                self.calls.append(node)
            for name in fields_of(node):
                value = getattr(node, name, None)
                place = (node, name)
                for child in value if isinstance(value, list) else (value,):
                    if isinstance(child, ast.AST):
                        self._above[child] = place
                        stack.append(child)
        self.calls.sort(key=lambda call: (call.lineno, call.col_offset))

    @cached_property
    def named(self) -> dict[str, list[ast.Call]]:
        """The calls whose function has a known dotted name, by that name, in the order of the text."""
        found: dict[str, list[ast.Call]] = {}
        for call in self.calls:
            name = self.qualified(call)
            if name is not None:
                found.setdefault(name, []).append(call)
        return found

    def above(self, node: ast.AST) -> Iterator[tuple[ast.AST, str]]:
        """What a node is in, innermost first, each with the field that holds it."""
        while node in self._above:
            node, name = self._above[node]
            yield node, name

    def within(self, node: ast.AST) -> Iterator[tuple[ast.AST, str]]:
        """As ``above``, up to the function that the node is in."""
        for outer, name in self.above(node):
            if isinstance(outer, (*FUNCTIONS, ast.ClassDef)):
                return
            yield outer, name

    def function(self, node: ast.AST) -> FunctionNode | None:
        """The innermost function that a node is in."""
        for outer, _ in self.above(node):
            if isinstance(outer, (ast.FunctionDef, ast.AsyncFunctionDef)):
                return outer
        return None

    def class_of(self, node: ast.AST) -> NodeClass | None:
        """The class of the file whose definition is the innermost that a node is in."""
        outer = self.definition(node)
        return next((each for each in self.file.classes if each.node is outer), None) if outer is not None else None

    def definition(self, node: ast.AST) -> ast.ClassDef | None:
        """The innermost definition of a class that a node is in."""
        return next((outer for outer, _ in self.above(node) if isinstance(outer, ast.ClassDef)), None)

    def is_dead(self, node: ast.AST) -> bool:
        """Whether a statement that always leaves the block is before a node."""
        if node in self._left:
            return True
        for outer, _ in self.above(node):
            if isinstance(outer, (*FUNCTIONS, ast.ClassDef)):
                return False
            if outer in self._left:
                return True
        return False

    def once(self, make: Callable[[Syntax], Answer]) -> Answer:
        """What something makes of the whole file, made once and kept as long as the tree is."""
        if make not in self._made:
            self._made[make] = make(self)
        answer: Answer = self._made[make]
        return answer

    @cached_property
    def _left(self) -> set[ast.AST]:
        """The statements that come in their block after one that always leaves it."""
        blocks = (getattr(outer, name) for outer, name in dict.fromkeys(self._above.values()))
        return {each for block in blocks if isinstance(block, list) for each in _after_end(block)}

    def catches(self, node: ast.AST, names: frozenset[str]) -> bool:
        """Whether a ``try`` around a node, in the same function, takes one of some exceptions or all of them."""
        return self.handler(node, names) is not None

    def handler(self, node: ast.AST, names: frozenset[str]) -> ast.ExceptHandler | None:
        """The first around a node, in the same function, that takes one of some exceptions or all of them."""
        outers = (outer for outer, name in self.within(node) if isinstance(outer, ast.Try) and name == "body")
        return next((each for outer in outers for each in outer.handlers if _takes(each, names)), None)

    def after(self, statement: ast.stmt) -> list[ast.stmt]:
        """The statements after one in its own block."""
        if statement not in self._above:
            return []
        outer, name = self._above[statement]
        block = getattr(outer, name)
        return block[block.index(statement) + 1 :] if isinstance(block, list) else []

    def qualified(self, call: ast.Call) -> str | None:
        """The dotted name of what is called, through the imports."""
        if call not in self._qualified:
            self._qualified[call] = self.file.qualified(call.func)
        return self._qualified[call]


def _after_end(block: list[ast.AST]) -> list[ast.AST]:
    """The statements of a block after the first that always ends it."""
    end = next((number for number, each in enumerate(block) if isinstance(each, _ENDS)), len(block))
    return block[end + 1 :]


def _takes(handler: ast.ExceptHandler, names: frozenset[str]) -> bool:
    if handler.type is None:
        return True
    named = (each.id if isinstance(each, ast.Name) else getattr(each, "attr", None) for each in ast.walk(handler.type))
    return any(name in names for name in named)


def own(nodes: Iterable[ast.AST]) -> Iterator[ast.AST]:
    """The nodes and all that is in them, in the order of the text, without functions and classes defined there."""
    stack = list(reversed(list(nodes)))
    while stack:
        node = stack.pop()
        yield node
        if not isinstance(node, (*FUNCTIONS, ast.ClassDef)):
            stack.extend(reversed(children(node)))


def own_calls(nodes: Iterable[ast.AST]) -> Iterator[ast.Call]:
    return (node for node in own(nodes) if isinstance(node, ast.Call))


def calls_through(
    methods: Mapping[str, ast.FunctionDef], method: str, depth: int, is_left_out: Callable[[ast.Call], bool]
) -> Iterator[ast.Call]:
    """The calls of a method and of those of its own class that it calls, so many deep; none of those left out, and
    nothing that only these reach."""
    seen: set[str] = set()
    todo = [(method, 0)]
    while todo:
        name, at = todo.pop()
        if name in seen or name not in methods or at > depth:
            continue
        seen.add(name)
        for call in own_calls(methods[name].body):
            if is_left_out(call):
                continue
            yield call
            if is_own(call.func):
                todo.append((call.func.attr, at + 1))


def methods_of(body: Iterable[ast.stmt], class_name: str) -> dict[str, ast.FunctionDef] | None:
    """The methods of a class among some statements; None when there is no such class."""
    cls = next((each for each in body if isinstance(each, ast.ClassDef) and each.name == class_name), None)
    return None if cls is None else {each.name: each for each in cls.body if isinstance(each, ast.FunctionDef)}


def body_of(function: ast.AST | None) -> list[ast.AST]:
    """The statements of a function; the expression of a lambda."""
    body = getattr(function, "body", [])
    return body if isinstance(body, list) else [body]
