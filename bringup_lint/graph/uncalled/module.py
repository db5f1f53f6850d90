"""The code of one file: what it mentions and sets, and where."""

from __future__ import annotations

import ast
from bisect import bisect_left
from collections.abc import Iterator
from functools import cached_property
from typing import TypeAlias

from bringup_lint.dataclass import dataclass
from bringup_lint.graph.memo import memo
from bringup_lint.model.python import is_own
from bringup_lint.model.python import last_name
from bringup_lint.pattern import regex

Function: TypeAlias = ast.FunctionDef | ast.AsyncFunctionDef
Block: TypeAlias = ast.FunctionDef | ast.AsyncFunctionDef | ast.ClassDef | ast.If
USES = 200
"""Places of a file that have a name: what has more is used somewhere."""
_DEEP = 100
"""Statements in each other that are looked at."""
_WORD = regex(r"\w+")
BY_NAME = r"""\b[gs]etattr\({}[^,]{{1,80}},(?!\s*r?(?:'\w+'|"\w+")\s*[,)])"""
"""A function or attribute that is got or set by a name that is computed; ``{}`` is what is before the object."""
PLAIN_BASES = frozenset({"object", "Node", "LifecycleNode", "ABC", "Generic", "Exception", "RuntimeError"})
"""Bases that call no method of a class but those with names of their own."""
_REFLECTS = regex(
    r"\b(?:globals|locals|vars|dir|getmembers|methodcaller|attrgetter)\(|__dict__|" + BY_NAME.format(""),
    hints="globals locals vars dir getmembers methodcaller attrgetter __dict__ getattr setattr",
)
_SETS = regex(r"\bsetattr\([^,]{1,80},\s*[\"'](?P<name>\w+)[\"']", hints="setattr")
_MAKES_OWN = regex(r"\bcls\(|\b__class__\(|\btype\(self\)\(", hints="cls( __class__ type(self)")
_MESSAGES = regex(r"(?:^|\.)(?:msg|srv|action|tkinter|math)$")
"""Modules that set nothing that is in capitals or the like."""
_PLAIN = frozenset({"staticmethod", "classmethod", "property", "override"})
"""Decorators that hand a function to nobody."""


@dataclass(eq=False)
class Module:
    """The code of one file."""

    path: str
    text: str
    tree: ast.Module

    def around(self, line: int) -> list[Block]:
        """The functions, classes and branches around a line, from outside to inside."""
        found: list[Block] = []
        each: ast.stmt | ast.Module | None = self.tree
        for _ in range(_DEEP):
            if each is None:
                break
            ends, statements = self._below(each)
            at = bisect_left(ends, line)
            each = statements[at] if at < len(statements) and statements[at].lineno <= line else None
            if isinstance(each, (ast.FunctionDef, ast.AsyncFunctionDef, ast.ClassDef, ast.If)):
                found.append(each)
        return found

    @memo
    def _below(self, each: ast.stmt | ast.Module) -> tuple[list[int], list[ast.stmt]]:
        """The statements directly in one, with the lines where they end."""
        statements = list(_statements(each))
        return [one.end_lineno or one.lineno for one in statements], statements

    def class_of(self, function: Function) -> ast.ClassDef | None:
        """The class of which a function is a method."""
        around = [each for each in self.around(function.lineno) if not isinstance(each, ast.If)]
        at = around.index(function) if function in around else 0
        owner = around[at - 1] if at else None
        return owner if isinstance(owner, ast.ClassDef) else None

    def owner(self, use: ast.expr) -> ast.ClassDef | None:
        """The class around an attribute of ``self`` that has a method of this name."""
        classes = [each for each in self.around(use.lineno) if isinstance(each, ast.ClassDef)] if is_own(use) else []
        return next((each for each in classes[-1:] if getattr(use, "attr", "") in self.methods(each)), None)

    def has_variable(self, use: ast.Name) -> bool:
        """Whether a name is known to be read in a function or in the file itself, where it is no method."""
        around = [each for each in self.around(use.lineno) if not isinstance(each, ast.If)]
        return use.lineno > 0 and not isinstance(next(iter(around[-1:]), None), ast.ClassDef)

    @memo
    def methods(self, cls: ast.ClassDef) -> frozenset[str]:
        return frozenset(each.name for each in cls.body if isinstance(each, (ast.FunctionDef, ast.AsyncFunctionDef)))

    @cached_property
    def classes(self) -> dict[str, list[ast.ClassDef]]:
        """Name -> the classes of the file itself."""
        found: dict[str, list[ast.ClassDef]] = {}
        for each in self.tree.body:
            if isinstance(each, ast.ClassDef):
                found.setdefault(each.name, []).append(each)
        return found

    @cached_property
    def bases(self) -> frozenset[str]:
        """What classes of the file build on."""
        classes = (each for each in self.nodes if isinstance(each, ast.ClassDef))
        return frozenset(last_name(base) for each in classes for base in each.bases)

    @cached_property
    def globals(self) -> frozenset[int]:
        """The places that assignments of the file itself set, by their identity."""
        assigned = (each for each in self.tree.body if isinstance(each, ast.Assign))
        return frozenset(id(target) for each in assigned for target in each.targets)

    @cached_property
    def is_reflected(self) -> bool:
        """Whether the file gets functions or attributes by names that it computes."""
        return _REFLECTS.search(self.text) is not None

    @cached_property
    def makes_own(self) -> bool:
        """Whether the file makes objects of a class without its name."""
        return _MAKES_OWN.search(self.text) is not None

    @cached_property
    def set_by_name(self) -> frozenset[str]:
        """The attributes that the file sets by a text."""
        return frozenset(match["name"] for match in _SETS.finditer(self.text))

    def may_import(self, name: str, line: int) -> bool:
        """Whether an import may bring a name, other than one of the file itself before a line that sets it anew."""
        return any(at > line for each in (name, "*") for at in self._imported.get(each, ()))

    @cached_property
    def _imported(self) -> dict[str, list[int]]:
        """The names that imports bring, each with the lines from which on it may have them; ``*`` where one may bring
        any."""
        first = {id(each) for each in self.tree.body}
        found: dict[str, list[int]] = {}
        for each in self.nodes:
            if isinstance(each, (ast.Import, ast.ImportFrom)):
                for alias in each.names:
                    if alias.name != "*" or not _MESSAGES.search(getattr(each, "module", None) or ""):
                        at = each.lineno if id(each) in first else len(self.text)
                        found.setdefault(alias.asname or alias.name, []).append(at)
        return found

    @cached_property
    def nodes(self) -> list[ast.AST]:
        return list(ast.walk(self.tree))

    @cached_property
    def calls(self) -> dict[int, ast.Call]:
        """The calls, each under the identity of what it calls."""
        return {id(each.func): each for each in self.nodes if isinstance(each, ast.Call)}

    @cached_property
    def uses(self) -> dict[str, list[ast.expr]]:
        """Name -> the expressions that have it: names, attributes, and texts that hold it."""
        documentation = {
            id(each.value) for each in self.nodes if isinstance(each, ast.Expr) and isinstance(each.value, ast.Constant)
        }
        found: dict[str, list[ast.expr]] = {}
        for each in self.nodes:
            if isinstance(each, ast.Name) and isinstance(each.ctx, ast.Load):
                found.setdefault(each.id, []).append(each)
            elif isinstance(each, ast.Attribute) and isinstance(each.ctx, ast.Load):
                found.setdefault(each.attr, []).append(each)
            elif isinstance(each, ast.Constant) and isinstance(each.value, str) and id(each) not in documentation:
                for word in set(_WORD.findall(each.value)):
                    found.setdefault(word, []).append(each)
        return found

    @cached_property
    def renamed(self) -> frozenset[str]:
        """What is imported under another name."""
        imports = (each for each in self.nodes if isinstance(each, (ast.Import, ast.ImportFrom)))
        return frozenset(alias.name.rpartition(".")[2] for each in imports for alias in each.names if alias.asname)

    @cached_property
    def stores(self) -> dict[str, list[ast.AST]]:
        """Name -> the places that set a variable or an attribute of this name."""
        found: dict[str, list[ast.AST]] = {}
        for each in self.nodes:
            if isinstance(each, ast.Name) and not isinstance(each.ctx, ast.Load):
                found.setdefault(each.id, []).append(each)
            elif isinstance(each, ast.Attribute) and not isinstance(each.ctx, ast.Load):
                found.setdefault(each.attr, []).append(each)
            elif isinstance(each, (ast.Global, ast.Nonlocal)):
                for name in each.names:
                    found.setdefault(name, []).append(each)
        return found

    @cached_property
    def values(self) -> dict[int, ast.expr]:
        """What plain assignments give, under the identity of the place that is set."""
        found: dict[int, ast.expr] = {}
        for each in self.nodes:
            if isinstance(each, ast.Assign):
                found.update({id(target): each.value for target in each.targets})
            elif isinstance(each, ast.AnnAssign) and each.value is not None:
                found[id(each.target)] = each.value
        return found


def _statements(each: ast.AST) -> Iterator[ast.stmt]:
    """The statements directly in one."""
    for child in ast.iter_child_nodes(each):
        if isinstance(child, ast.stmt):
            yield child
        elif isinstance(child, (ast.ExceptHandler, ast.match_case)):
            yield from child.body


def has_plain_decorators(function: Function) -> bool:
    """Whether the decorators of a function hand it to nobody."""
    return all(last_name(each) in _PLAIN for each in function.decorator_list)
