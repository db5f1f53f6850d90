"""Branches whose condition is the same constant everywhere: an argument that no call gives, an attribute or a variable
of a module that is set to one value alone."""

from __future__ import annotations

import ast

from bringup_lint.graph.memo import memo
from bringup_lint.graph.uncalled.code import Code
from bringup_lint.graph.uncalled.module import USES
from bringup_lint.graph.uncalled.module import Function
from bringup_lint.graph.uncalled.module import Module
from bringup_lint.graph.uncalled.module import has_plain_decorators
from bringup_lint.model.python import is_own
from bringup_lint.model.python import last_name

_DEPTH = 4
"""Calls in a row that hand an argument on."""
_OF_ALL = ("__getattr__", "__getattribute__", "__setattr__")
"""Functions of a class that answer for any attribute."""
_NESTED = 20
"""Conditions in each other that are looked at."""
_ARGUMENTS = 50
"""Arguments of a function that is looked at."""


class Branches:
    def __init__(self, code: Code) -> None:
        self._code = code

    def skip(self, module: Module, branch: ast.If, line: int) -> bool:
        """Whether a line of an ``if`` statement is in the part that is never taken."""
        body, other = branch.body, branch.orelse
        if line < body[0].lineno or (line == branch.lineno):
            return False
        is_body = line <= (body[-1].end_lineno or 0)
        if not is_body and not other:
            return False
        return self._of_branch((module, branch)) is (not is_body)

    @memo
    def _of_branch(self, asked: tuple[Module, ast.If]) -> bool | None:
        module, branch = asked
        return self._truth(module, branch.test, _DEPTH)

    def _truth(self, module: Module, test: ast.expr, depth: int, nested: int = _NESTED) -> bool | None:
        """Whether an expression is true or false; None when that is not known."""
        if isinstance(test, ast.Constant):
            return bool(test.value)
        if not nested:
            return None
        if isinstance(test, ast.UnaryOp) and isinstance(test.op, ast.Not):
            found = self._truth(module, test.operand, depth, nested - 1)
            return None if found is None else not found
        if isinstance(test, ast.BoolOp):
            ends = isinstance(test.op, ast.Or)
            parts = [self._truth(module, each, depth, nested - 1) for each in test.values]
            return ends if ends in parts else None if None in parts else not ends
        if not depth:
            return None
        if isinstance(test, ast.Name):
            return self._of_name(module, test, depth - 1)
        return self._of_attribute(module, test, depth - 1) if is_own(test) else None

    def _of_name(self, module: Module, test: ast.Name, depth: int) -> bool | None:
        for function in reversed(module.around(test.lineno)):
            if isinstance(function, (ast.FunctionDef, ast.AsyncFunctionDef)) and test.id in self._arguments(function):
                return self._of_argument((module, function, test.id, depth))
        return self._of_variable((module, test.id, depth))

    @memo
    def _arguments(self, function: Function) -> frozenset[str]:
        arguments = (*function.args.posonlyargs, *function.args.args, *function.args.kwonlyargs)
        return frozenset(each.arg for each in arguments)

    @memo
    def _of_variable(self, asked: tuple[Module, str, int]) -> bool | None:
        """What a variable of a module is, when it is set once."""
        module, name, depth = asked
        stores = _plain(module, name)
        is_single = len(stores) == 1 and id(stores[0]) in module.globals
        is_plain = is_single and not module.may_import(name, _line(stores[0])) and not module.is_reflected
        elsewhere = self._code.modules_with(name) if is_plain else None
        if elsewhere is None or any(
            name in other.set_by_name or any(isinstance(each, ast.Attribute) for each in other.stores.get(name, ()))
            for other in elsewhere
        ):
            return None
        return self._truth(module, module.values[id(stores[0])], depth)

    @memo
    def _of_argument(self, asked: tuple[Module, Function, str, int]) -> bool | None:
        """What an argument is in all calls of the tree: its default where none gives it."""
        module, function, name, depth = asked
        is_set = any(function.lineno <= _line(each) <= (function.end_lineno or 0) for each in _plain(module, name))
        default = _default(function, name) if len(self._arguments(function)) <= _ARGUMENTS and not is_set else None
        cls = module.class_of(function)
        if (
            default is None
            or function.args.kwarg is not None
            or not has_plain_decorators(function)
            or (cls is not None and not self._code.has_known_bases(cls))
        ):
            return None
        called = cls.name if cls is not None and function.name == "__init__" else function.name
        modules = self._code.modules_with(called)
        if modules is None or any(called in each.renamed for each in modules):
            return None
        if called != function.name and any(each.makes_own for each in modules):
            return None
        uses = [(other, use) for other in modules for use in other.uses.get(called, ())]
        if not 0 < len(uses) <= USES:
            return None
        truths = {self._truth(module, default, depth)}
        shift = 1 if cls is not None and "staticmethod" not in map(last_name, function.decorator_list) else 0
        for other, use in uses:
            call = other.calls.get(id(use))
            given = _given(call, function, name, shift) if call is not None else None
            if given is None:
                return None
            truths.update(self._truth(other, each, depth) for each in given)
        return next(iter(truths)) if len(truths) == 1 else None

    def _of_attribute(self, module: Module, test: ast.expr, depth: int) -> bool | None:
        assert isinstance(test, ast.Attribute)
        classes = [each for each in module.around(test.lineno) if isinstance(each, ast.ClassDef)]
        return self._of_member((module, classes[-1], test.attr, depth)) if classes else None

    @memo
    def _of_member(self, asked: tuple[Module, ast.ClassDef, str, int]) -> bool | None:
        """What an attribute of ``self`` is, when only its class sets it."""
        module, cls, name, depth = asked
        modules = self._code.modules_with(name) if not module.is_reflected else None
        if modules is None or self._code.sets_by_name or not self._is_last(cls):
            return None
        family = [(module, cls), *self._code.bases(cls)]
        if any(other.is_reflected or not other.methods(each).isdisjoint((name, *_OF_ALL)) for other, each in family):
            return None
        if (
            any(name in each.set_by_name for each in modules)
            or sum(len(each.stores.get(name, ())) for each in modules) > USES
        ):
            return None
        stores = [each for other in modules for each in other.stores.get(name, ())]
        if any(isinstance(each, ast.Attribute) and not is_own(each) for each in stores):
            return None
        own = [
            (other, each)
            for other, owner in family
            for each in other.stores.get(name, ())
            if owner.lineno <= _line(each) <= (owner.end_lineno or 0)
        ]
        values = [(other, other.values.get(id(each)) if is_own(each) else None) for other, each in own]
        truths = {None if value is None else self._truth(other, value, depth) for other, value in values}
        return next(iter(truths)) if len(truths) == 1 else None

    @memo
    def _is_last(self, cls: ast.ClassDef) -> bool:
        """Whether all that a class builds on is known, and none builds on it."""
        if not self._code.has_known_bases(cls):
            return False
        modules = self._code.modules_with(cls.name)
        return modules is not None and not any(cls.name in each.renamed or cls.name in each.bases for each in modules)


def _plain(module: Module, name: str) -> list[ast.AST]:
    """The places that set a variable of this name."""
    return [each for each in module.stores.get(name, ()) if not isinstance(each, ast.Attribute)]


def _default(function: Function, name: str) -> ast.expr | None:
    """The constant that an argument has where a call does not give it."""
    arguments = function.args
    positional = [*arguments.posonlyargs, *arguments.args]
    pairs = [
        *zip(reversed(positional), reversed(arguments.defaults), strict=False),
        *zip(arguments.kwonlyargs, arguments.kw_defaults, strict=True),
    ]
    found = next((value for each, value in pairs if each.arg == name), None)
    return found if isinstance(found, ast.Constant) else None


def _given(call: ast.Call, function: Function, name: str, shift: int) -> list[ast.expr] | None:
    """What a call gives for an argument, at most one value; None when that cannot be told."""
    if any(isinstance(each, ast.Starred) for each in call.args) or any(each.arg is None for each in call.keywords):
        return None
    positional = [each.arg for each in (*function.args.posonlyargs, *function.args.args)]
    at = positional.index(name) - shift if name in positional else len(call.args)
    by_name = [each.value for each in call.keywords if each.arg == name]
    return by_name or call.args[at : at + 1]


def _line(place: ast.AST) -> int:
    line: int = getattr(place, "lineno", 0)
    return line
