"""Callbacks made in a loop that use its variable, of which all of them see the last value."""

from __future__ import annotations

import ast
from collections.abc import Iterator
from typing import Union

from bringup_lint.graph.nodes.sources.syntax import FUNCTIONS
from bringup_lint.graph.nodes.sources.syntax import Syntax
from bringup_lint.graph.nodes.sources.syntax import own
from bringup_lint.graph.nodes.sources.syntax import own_calls
from bringup_lint.model.python import called_name
from bringup_lint.model.python import walk
from bringup_lint.model.python import written
from bringup_lint.named_tuple import NamedTuple
from bringup_lint.pattern import regex

Loop = Union[ast.For, ast.ListComp, ast.SetComp, ast.DictComp]

_KEEPS = frozenset(
    "create_subscription create_timer create_service create_guard_condition add_done_callback registerCallback "
    "add_on_set_parameters_callback ActionServer send_goal_async".split()
)
"""Functions of rclpy and message_filters that call what they are handed when the loop has ended."""
_LEAVES = (ast.Break, ast.Continue, ast.Return, ast.Raise, ast.Await, ast.Yield, ast.YieldFrom)
_SEVERAL = 2
_MAY_CALL = regex(r"spin|sleep|wait|join|result|run")
_LOGGERS = ("log", "logger", "logger()")
_WORDING = ("print", "str", "repr", "len", "format")
"""Functions that tell people, or make what is told."""


class LateBound(NamedTuple):
    use: ast.Name
    """Where the callback uses the variable."""
    loop: ast.Name
    """Where the loop gives it a value."""
    call: ast.Call
    """What is handed the callback."""
    is_logged: bool
    """The callback only writes the value to the log."""


def late_bound(syntax: Syntax) -> Iterator[LateBound]:
    """The first use in each lambda."""
    for call in syntax.calls:
        name = called_name(call)
        if name not in _KEEPS:
            continue
        variables = dict(_variables(syntax, call))
        if not variables:
            continue
        for given in (*call.args, *(each.value for each in call.keywords)):
            uses = _used(given, set(variables)) if isinstance(given, ast.Lambda) else []
            told = _told(given) if uses else set()
            use = next((each for each in uses if each not in told), next(iter(uses), None))
            if use is not None:
                yield LateBound(use, variables[use.id], call, use in told)


def _variables(syntax: Syntax, call: ast.Call) -> Iterator[tuple[str, ast.Name]]:
    """What the loops around a call, in the same function, give another value in each turn."""
    conditions: list[ast.expr] = []
    for outer, field in syntax.above(call):
        if isinstance(outer, (*FUNCTIONS, ast.ClassDef)):
            return
        if isinstance(outer, (ast.If, ast.IfExp)) and field != "test":
            conditions.append(outer.test)
        if isinstance(outer, ast.Match):
            conditions.append(outer.subject)
        if isinstance(outer, ast.For) and field == "body":
            found = dict(_of_loop(outer))
        elif isinstance(outer, (ast.ListComp, ast.SetComp, ast.DictComp)):
            found = {name: each for part in outer.generators for name, each in _names(part.target)}
            conditions += [test for part in outer.generators for test in part.ifs]
        else:
            continue
        if not any(_uses(test, set(found)) for test in conditions):
            yield from found.items()


def _of_loop(loop: ast.For) -> Iterator[tuple[str, ast.Name]]:
    if _ends_at_once(loop.iter):
        return
    inside = list(own(list(loop.body)))
    waits = any(_MAY_CALL.search(written(each.func)) for each in own_calls(list(loop.body)))
    if waits or any(isinstance(each, _LEAVES) for each in inside):
        return
    found = dict(_names(loop.target))
    for each in inside:
        if isinstance(each, ast.Assign) and _uses(each.value, set(found)):
            found |= {name: target for part in each.targets for name, target in _names(part)}
    yield from found.items()


def _ends_at_once(values: ast.expr) -> bool:
    """Whether there is one turn at most: ``["front"]``, ``range(1)``, ``{"front": 1}.items()``, ``names[:1]``."""
    if isinstance(values, ast.Call):
        values = values.func.value if isinstance(values.func, ast.Attribute) else next(iter(values.args), values)
    if isinstance(values, ast.Subscript) and isinstance(values.slice, ast.Slice):
        return True
    if isinstance(values, ast.Dict):
        return len(values.keys) < _SEVERAL
    if isinstance(values, (ast.List, ast.Tuple)):
        return len(values.elts) < _SEVERAL
    return isinstance(values, ast.Constant) and values.value == 1


def _names(target: ast.expr) -> Iterator[tuple[str, ast.Name]]:
    """The plain names that an assignment or loop gives a value."""
    parts = target.elts if isinstance(target, (ast.Tuple, ast.List)) else [target]
    for part in parts:
        if isinstance(part, ast.Name):
            yield part.id, part
        elif isinstance(part, (ast.Tuple, ast.List)):
            yield from _names(part)


def _uses(expression: ast.expr, names: set[str]) -> bool:
    return any(isinstance(each, ast.Name) and each.id in names for each in walk(expression))


def _used(function: ast.Lambda, names: set[str]) -> list[ast.Name]:
    """Where a lambda reads names that are none of its own."""
    given = function.args
    own_names = {each.arg for each in (*given.posonlyargs, *given.args, *given.kwonlyargs)}
    own_names |= {each.arg for each in (given.vararg, given.kwarg) if each is not None}
    inside = [each for each in walk(function.body) if isinstance(each, ast.Name)]
    own_names |= {each.id for each in inside if isinstance(each.ctx, ast.Store)}
    own_names |= {
        each.arg for inner in walk(function.body) if isinstance(inner, ast.Lambda) for each in inner.args.args
    }
    return [each for each in inside if each.id in names and each.id not in own_names]


def _told(function: ast.AST) -> set[ast.AST]:
    """What is inside of calls to a logger, and of no others."""
    calls = [each for each in walk(function) if isinstance(each, ast.Call)]
    telling, acting = [each for each in calls if _tells(each)], [each for each in calls if not _tells(each)]
    inside = {inner for call in telling for inner in walk(call)}
    return inside - {inner for call in acting for given in (*call.args, *call.keywords) for inner in walk(given)}


def _tells(call: ast.Call) -> bool:
    owner, _, name = written(call.func).rpartition(".")
    return name in _WORDING or owner.endswith(_LOGGERS)
