"""What a rule needs to find anything, read from its syntax: the lists that it loops over, and the settings and types of
units that it asks for.

A rule yields findings. Around each ``yield`` are loops over lists and tests of values, and where one of the lists is
empty, or one of the values absent, that ``yield`` is not reached. What is not understood counts as given, so that a
rule is never taken for silent that could speak.
"""

from __future__ import annotations

import ast
from collections.abc import Callable
from collections.abc import Iterable
from collections.abc import Iterator
from dataclasses import field
from functools import cached_property
from typing import Any
from typing import NamedTuple

from bringup_lint.dataclass import dataclass

Path = tuple[Any, ...]
Atom = tuple[str, Any]
"""One thing that must be there: ``("some", path)`` a list of the robot that is not empty, ``("true", path)`` a value
of the robot that is true, ``("key", "KillMode")`` a unit that sets it, ``("type", "timer")`` and
``("manager", "user")`` a unit of this type and manager. A path is a tuple of names of attributes, and of tuples for
calls: the name and the arguments."""
Needs = frozenset[frozenset[Atom]]
"""Alternatives, one of which must be there as a whole."""

NOTHING: Needs = frozenset([frozenset()])
"""Needs that are always met."""
NEVER: Needs = frozenset()
"""Needs that nothing meets."""
_MOST_ALTERNATIVES = 24
_DEEPEST = 6
"""How many calls of a rule's own functions are followed."""
_UNIT_LISTS = frozenset({"judged", "services", "ros", "ros1", "presumed_ros", "dds"})
"""The lists of ``robot.units`` that hold units."""
_KEYED = frozenset({"get", "flag", "has", "values", "words", "assignments", "seconds", "naming"})
"""Methods of a unit that give nothing for a key that it does not set."""
_SAME_ITEMS = frozenset({"list", "tuple", "set", "frozenset", "sorted", "reversed", "enumerate", "iter"})
_FRESH = frozenset({"list", "dict", "set", "defaultdict", "Counter", "sorted"})
_READING = frozenset({"len", "any", "all", "min", "max", "sum", "zip", "next", "dict", "map", "filter", *_SAME_ITEMS})
_READING_METHODS = frozenset({"items", "values", "keys", "get"})


def either(*each: Needs) -> Needs:
    """One of several needs."""
    together = frozenset().union(*each)
    return NOTHING if frozenset() in together else together


def both(one: Needs, other: Needs) -> Needs:
    """All of two needs; only one of them where the alternatives would be many."""
    if len(one) * len(other) > _MOST_ALTERNATIVES:
        return min(one, other, key=len)
    return either(frozenset(mine | theirs for mine in one for theirs in other))


def needs_of(text: str) -> Needs:
    """What the rule in a file needs."""
    tree = ast.parse(text)
    functions = {node.name: node for node in tree.body if isinstance(node, ast.FunctionDef)}
    rule = next((node for node in functions.values() if _is_rule(node)), None)
    if rule is None or [parameter.arg for parameter in rule.args.args] != ["robot"]:
        return NOTHING
    try:
        return _Body(rule, {"robot": _ROBOT}, functions).items
    except RecursionError:
        return NOTHING


def _is_rule(node: ast.FunctionDef) -> bool:
    return any(
        isinstance(each, ast.Call) and isinstance(each.func, ast.Name) and each.func.id == "rule"
        for each in node.decorator_list
    )


class _Value(NamedTuple):
    """What a name is: an expression in a body, or the robot, or a unit."""

    expression: ast.expr | None
    body: _Body | None
    known: str = ""


_ROBOT = _Value(None, None, "robot")
_UNIT = _Value(None, None, "unit")


@dataclass(eq=False)
class _Body:
    """A function with what its parameters are."""

    function: ast.FunctionDef
    names: dict[str, _Value]
    functions: dict[str, ast.FunctionDef]
    depth: int = 0
    _uses: dict[str, list[Needs]] | None = None
    """Name -> what is needed to get to the places where it is used otherwise than to be read; None before the first
    walk."""
    _noted: dict[str, list[Needs]] = field(default_factory=dict)
    _asked: set[str] = field(default_factory=set)
    _yielded: list[Needs] = field(default_factory=list)
    _returned: list[tuple[ast.expr, Needs]] = field(default_factory=list)

    @cached_property
    def items(self) -> Needs:
        """What is needed for the call to give an item."""
        self._walk()
        returned = (both(given, self.some(value)) for value, given in self._returned)
        return either(*self._yielded, *([] if self._is_generator else returned))

    @cached_property
    def truth(self) -> Needs:
        """What is needed for the call to give a true value."""
        self._walk()
        if self._is_generator:
            return NOTHING
        return either(*(both(given, self.true(value)) for value, given in self._returned))

    @cached_property
    def _is_generator(self) -> bool:
        return any(isinstance(node, (ast.Yield, ast.YieldFrom)) for node in _own(self.function))

    def _walk(self) -> None:
        """Twice: the second time it is known where lists are filled."""
        self._bind()
        for _ in range(2):
            self._yielded, self._returned, self._noted = [], [], {}
            self._block(self.function.body, NOTHING)
            self._uses = self._noted

    def _bind(self) -> None:
        """The names that are given a value once. All others may be anything."""
        stored: dict[str, int] = {}
        for node in ast.walk(self.function):
            if isinstance(node, ast.Name) and not isinstance(node.ctx, ast.Load):
                stored[node.id] = stored.get(node.id, 0) + 1
            elif isinstance(node, (ast.Global, ast.Nonlocal)):
                stored.update(dict.fromkeys(node.names, 2))
        given_again = stored.keys() & self.names.keys()
        for name in given_again:
            del self.names[name]
        once = {name for name, count in stored.items() if count == 1} - given_again
        for node in _own(self.function):
            target, value = _assigned(node)
            if target is not None and value is not None and target.id in once:
                self.names[target.id] = _Value(value, self)
        for node in _own(self.function):
            for each, listed in _looped(node):
                if isinstance(each, ast.Name) and each.id in once and self._gives_units(listed):
                    self.names[each.id] = _UNIT

    def _gives_units(self, listed: ast.expr) -> bool:
        if isinstance(listed, (ast.Tuple, ast.List)):
            return all(isinstance(each, ast.Starred) and self._gives_units(each.value) for each in listed.elts)
        path = self.path(listed)
        return path is not None and len(path) == 2 and path[0] == "units" and path[1] in _UNIT_LISTS

    # Statements: ``given`` is what is needed to get there; what comes back is needed to get past, or None.

    def _block(self, statements: Iterable[ast.stmt], given: Needs) -> Needs | None:
        for statement in statements:
            after = self._statement(statement, given)
            if after is None:
                return None
            given = after
        return given

    def _statement(self, node: ast.stmt, given: Needs) -> Needs | None:
        if isinstance(node, (ast.For, ast.AsyncFor)):
            self._note_uses(node.iter, given)
            self._block(node.body, both(given, self.some(node.iter)))
            self._block(node.orelse, given)
            return given
        if isinstance(node, ast.If):
            self._note_uses(node.test, given)
            after = self._block(node.body, both(given, self.true(node.test)))
            otherwise = self._block(node.orelse, both(given, self.false(node.test)))
            return otherwise if after is None else after if otherwise is None else given
        if isinstance(node, ast.While):
            self._note_uses(node.test, given)
            self._block(node.body, given)
            self._block(node.orelse, given)
            return given
        if isinstance(node, (ast.With, ast.Try, ast.Match)):
            for inner in _inner_blocks(node):
                self._block(inner, given)
            self._note_uses_of_head(node, given)
            return given
        return self._simple(node, given)

    def _simple(self, node: ast.stmt, given: Needs) -> Needs | None:
        self._note_uses(node, given)
        if not isinstance(node, (ast.FunctionDef, ast.ClassDef)):
            for each in _own(node):
                if isinstance(each, ast.Yield):
                    self._yielded.append(given)
                elif isinstance(each, ast.YieldFrom):
                    self._yielded.append(both(given, self.some(each.value)))
        if isinstance(node, ast.Return):
            if node.value is not None:
                self._returned.append((node.value, given))
            return None
        return None if isinstance(node, (ast.Raise, ast.Continue, ast.Break)) else given

    def _note_uses(self, node: ast.AST, given: Needs) -> None:
        reading = set(_only_read(node))
        for each in ast.walk(node):
            if isinstance(each, ast.Name) and isinstance(each.ctx, ast.Load) and each not in reading:
                self._noted.setdefault(each.id, []).append(given)

    def _note_uses_of_head(self, node: ast.stmt, given: Needs) -> None:
        inner = {each for block in _inner_blocks(node) for statement in block for each in ast.walk(statement)}
        for each in ast.walk(node):
            if isinstance(each, ast.Name) and isinstance(each.ctx, ast.Load) and each not in inner:
                self._noted.setdefault(each.id, []).append(given)

    # Expressions.

    def path(self, node: ast.expr) -> Path | None:
        """The way from the robot to a value; None for a value that is no plain part of it."""
        if isinstance(node, ast.Name):
            value = self.names.get(node.id)
            if value is None or value is _UNIT:
                return None
            return () if value.expression is None or value.body is None else value.body.path(value.expression)
        if isinstance(node, ast.Attribute):
            base = self.path(node.value)
            return None if base is None else (*base, node.attr)
        if isinstance(node, ast.Call) and isinstance(node.func, ast.Attribute) and not node.keywords:
            base = self.path(node.func.value)
            words = [each.value for each in node.args if isinstance(each, ast.Constant)]
            if base is not None and words and len(words) == len(node.args) and all(isinstance(w, str) for w in words):
                return (*base, (node.func.attr, *words))
        return None

    def some(self, node: ast.expr) -> Needs:
        """What is needed for an expression to have an item."""
        path = self.path(node)
        if path:
            return frozenset([frozenset([("some", path)])])
        if isinstance(node, ast.Name):
            return self._of_name(node, _Body.some)
        if isinstance(node, (ast.List, ast.Tuple, ast.Set)):
            return either(*(self.some(e.value) if isinstance(e, ast.Starred) else NOTHING for e in node.elts))
        if isinstance(node, ast.Dict):
            return NOTHING if node.keys else NEVER
        if isinstance(node, (ast.ListComp, ast.SetComp, ast.GeneratorExp, ast.DictComp)):
            return self._comprehended(node)
        if isinstance(node, ast.BinOp) and isinstance(node.op, (ast.Add, ast.BitOr)):
            return either(self.some(node.left), self.some(node.right))
        if isinstance(node, ast.IfExp):
            chosen = both(self.true(node.test), self.some(node.body))
            return either(chosen, both(self.false(node.test), self.some(node.orelse)))
        if isinstance(node, ast.BoolOp) and isinstance(node.op, ast.Or):
            return either(*map(self.some, node.values))
        if isinstance(node, ast.NamedExpr):
            return self.some(node.value)
        if isinstance(node, ast.Call):
            return self._called(node, _Body.some)
        if isinstance(node, ast.Subscript) and isinstance(node.slice, ast.Slice):
            return self.some(node.value)
        return NOTHING

    def _comprehended(self, node: ast.ListComp | ast.SetComp | ast.GeneratorExp | ast.DictComp) -> Needs:
        needs = NOTHING
        for each in node.generators:
            needs = both(needs, self.some(each.iter))
            for test in each.ifs:
                needs = both(needs, self.true(test))
        return needs

    def _of_name(self, node: ast.Name, ask: Callable[[_Body, ast.expr], Needs]) -> Needs:
        value = self.names.get(node.id)
        if value is None or value.expression is None or value.body is None:
            return NOTHING
        if node.id in self._asked:
            return NOTHING
        self._asked.add(node.id)
        try:
            needs = ask(value.body, value.expression)
        finally:
            self._asked.discard(node.id)
        return either(needs, *self._filled(node.id, value)) if _is_fresh(value.expression) else needs

    def _filled(self, name: str, value: _Value) -> Iterator[Needs]:
        """What is needed where something may be put into a list that a name holds."""
        if value.body is not self or self._uses is None:
            yield NOTHING
        else:
            yield from self._uses.get(name, ())

    def _called(self, node: ast.Call, ask: Callable[[_Body, ast.expr], Needs]) -> Needs:
        function = node.func
        if isinstance(function, ast.Name) and function.id in self.functions:
            return self._own_function(node, self.functions[function.id], ask)
        if isinstance(function, ast.Name) and function.id in _SAME_ITEMS and len(node.args) == 1:
            return self.some(node.args[0])
        if isinstance(function, ast.Name) and function.id in _FRESH and not node.args:
            return NEVER if not node.keywords else NOTHING
        if isinstance(function, ast.Name) and function.id == "defaultdict":
            return NEVER if len(node.args) == 1 else NOTHING
        if isinstance(function, ast.Attribute) and function.attr in ("items", "values", "keys") and not node.args:
            return self.some(function.value)
        if isinstance(function, ast.Attribute) and function.attr == "fromkeys" and node.args:
            return self.some(node.args[0])
        return self._keys(node)

    def _own_function(
        self, node: ast.Call, function: ast.FunctionDef, ask: Callable[[_Body, ast.expr], Needs]
    ) -> Needs:
        named = function.args
        plain = not (function.decorator_list or named.vararg or named.kwarg or named.posonlyargs)
        starred = any(isinstance(each, ast.Starred) for each in node.args) or any(
            not each.arg for each in node.keywords
        )
        if self.depth >= _DEEPEST or not plain or starred:
            return NOTHING
        values = {parameter.arg: self._value(each) for parameter, each in zip(named.args, node.args, strict=False)}
        values.update((str(each.arg), self._value(each.value)) for each in node.keywords)
        body = _Body(function, values, self.functions, self.depth + 1)
        return body.items if ask is _Body.some else body.truth

    def _value(self, node: ast.expr) -> _Value:
        """What is given to a parameter."""
        if isinstance(node, ast.Name):
            value = self.names.get(node.id, _Value(node, self))
            return _Value(node, self) if value.expression is not None and _is_fresh(value.expression) else value
        return _Value(node, self)

    def _keys(self, node: ast.expr) -> Needs:
        """What is needed for a question to a unit to be answered."""
        if not isinstance(node, ast.Call) or not isinstance(node.func, ast.Attribute) or not self._is_unit(node.func):
            return NOTHING
        words = [each.value for each in node.args if isinstance(each, ast.Constant) and isinstance(each.value, str)]
        if node.func.attr not in _KEYED or not words or not isinstance(node.args[0], ast.Constant):
            return NOTHING
        if node.func.attr != "seconds":
            return frozenset([frozenset([("key", words[0])])])
        if len(words) != len(node.args):
            return NOTHING
        return frozenset(frozenset([("key", word)]) for word in words)

    def _is_unit(self, node: ast.Attribute) -> bool:
        """Whether an attribute is one of a unit."""
        return isinstance(node.value, ast.Name) and self.names.get(node.value.id) is _UNIT

    def true(self, node: ast.expr) -> Needs:
        """What is needed for a test to hold."""
        if isinstance(node, ast.UnaryOp) and isinstance(node.op, ast.Not):
            return self.false(node.operand)
        if isinstance(node, ast.BoolOp):
            return self._joined(node, isinstance(node.op, ast.And), self.true)
        if isinstance(node, ast.NamedExpr):
            return self.true(node.value)
        if isinstance(node, ast.Compare):
            return self._compared(node, holds=True)
        if isinstance(node, ast.Constant):
            return NOTHING if node.value else NEVER
        path = self.path(node)
        if path:
            return frozenset([frozenset([("true", path)])])
        if isinstance(node, ast.Name):
            return self._of_name(node, _Body.true)
        if isinstance(node, (ast.List, ast.Tuple, ast.Set, ast.Dict, ast.ListComp, ast.SetComp, ast.DictComp)):
            return self.some(node)
        if isinstance(node, ast.IfExp):
            chosen = both(self.true(node.test), self.true(node.body))
            return either(chosen, both(self.false(node.test), self.true(node.orelse)))
        if isinstance(node, ast.Attribute) and node.attr in ("at", "value"):
            return self._setting(node.value)
        if isinstance(node, ast.Call):
            return self._true_call(node)
        return NOTHING

    def _true_call(self, node: ast.Call) -> Needs:
        if isinstance(node.func, ast.Name) and node.func.id == "any" and len(node.args) == 1:
            if not isinstance(node.args[0], ast.GeneratorExp):
                return self.some(node.args[0])
            return both(self.some(node.args[0]), self.true(node.args[0].elt))
        if isinstance(node.func, ast.Name) and node.func.id in ("enumerate", "reversed", "iter"):
            return NOTHING
        return self._called(node, _Body.true)

    def false(self, node: ast.expr) -> Needs:
        """What is needed for a test not to hold."""
        if isinstance(node, ast.UnaryOp) and isinstance(node.op, ast.Not):
            return self.true(node.operand)
        if isinstance(node, ast.BoolOp):
            return self._joined(node, isinstance(node.op, ast.Or), self.false)
        if isinstance(node, ast.Compare):
            return self._compared(node, holds=False)
        return NOTHING

    def _joined(self, node: ast.BoolOp, all_of: bool, ask: Callable[[ast.expr], Needs]) -> Needs:
        if not all_of:
            return either(*map(ask, node.values))
        needs = NOTHING
        for each in node.values:
            needs = both(needs, ask(each))
        return needs

    def _compared(self, node: ast.Compare, *, holds: bool) -> Needs:
        """``unit.type == "timer"``, ``value is not None``, ``unit.get("Type") in ("notify", "dbus")``."""
        if len(node.ops) != 1:
            return NOTHING
        left, (operator,), (right,) = node.left, node.ops, node.comparators
        equal = isinstance(operator, (ast.Eq, ast.In) if holds else (ast.NotEq, ast.NotIn))
        if isinstance(right, ast.Constant) and right.value is None:
            return self._setting(left) if isinstance(operator, ast.IsNot if holds else ast.Is) else NOTHING
        if not equal:
            return NOTHING
        words = right.elts if isinstance(right, (ast.Tuple, ast.List, ast.Set)) else [right]
        if not all(isinstance(each, ast.Constant) and isinstance(each.value, str) for each in words):
            return NOTHING
        if isinstance(operator, (ast.In, ast.NotIn)) and isinstance(right, ast.Constant):
            return NOTHING
        if isinstance(left, ast.Attribute) and left.attr in ("type", "manager") and self._is_unit(left):
            return frozenset(frozenset([(left.attr, each.value)]) for each in words if isinstance(each, ast.Constant))
        return self._setting(left)

    def _setting(self, node: ast.expr) -> Needs:
        """What is needed for a value not to be None: a unit sets it."""
        if isinstance(node, ast.NamedExpr):
            return self._setting(node.value)
        if isinstance(node, ast.Attribute) and node.attr in ("at", "value"):
            return self._setting(node.value)
        if isinstance(node, ast.Name):
            value = self.names.get(node.id)
            if value is None or value.expression is None or value.body is None:
                return NOTHING
            return value.body._setting(value.expression)
        return self._keys(node) if _asks_for_one(node) else NOTHING


def _asks_for_one(node: ast.expr) -> bool:
    return isinstance(node, ast.Call) and isinstance(node.func, ast.Attribute) and node.func.attr == "get"


def _own(node: ast.AST) -> Iterator[ast.AST]:
    """A node and what is below it, without the functions in it."""
    yield node
    for child in ast.iter_child_nodes(node):
        if not isinstance(child, (ast.FunctionDef, ast.Lambda, ast.ClassDef)):
            yield from _own(child)


def _assigned(node: ast.AST) -> tuple[ast.Name | None, ast.expr | None]:
    """The name that a statement gives a value, and the value."""
    if isinstance(node, ast.Assign):
        target: ast.expr = node.targets[0] if len(node.targets) == 1 else ast.Tuple(node.targets)
    elif isinstance(node, (ast.AnnAssign, ast.NamedExpr)):
        target = node.target
    else:
        return None, None
    return (target, node.value) if isinstance(target, ast.Name) else (None, None)


def _looped(node: ast.AST) -> Iterator[tuple[ast.expr, ast.expr]]:
    """The targets of loops with what they loop over."""
    if isinstance(node, (ast.For, ast.comprehension)):
        yield node.target, node.iter


def _inner_blocks(node: ast.stmt) -> Iterator[list[ast.stmt]]:
    if isinstance(node, ast.Match):
        yield from (case.body for case in node.cases)
    if isinstance(node, (ast.With, ast.Try)):
        yield node.body
    if isinstance(node, ast.Try):
        yield from (handler.body for handler in node.handlers)
        yield node.orelse
        yield node.finalbody


def _is_fresh(node: ast.expr) -> bool:
    """Whether an expression makes a list that may be filled later."""
    if isinstance(node, ast.Call):
        return isinstance(node.func, ast.Name)
    return isinstance(node, (ast.List, ast.Dict, ast.Set, ast.ListComp, ast.SetComp, ast.DictComp, ast.BinOp))


def _only_read(node: ast.AST) -> Iterator[ast.Name]:
    """The names in places where nothing can be put into what they hold."""
    if isinstance(node, ast.expr):
        yield from _tested(node)
    for each in ast.walk(node):
        reads: Iterable[ast.AST] = ()
        if isinstance(each, ast.Call) and isinstance(each.func, ast.Name) and each.func.id in _READING:
            reads = each.args
        elif isinstance(each, ast.Call) and isinstance(each.func, ast.Attribute):
            reads = [each.func.value] if each.func.attr in _READING_METHODS else []
        elif isinstance(each, ast.Compare):
            reads = [each.left, *each.comparators]
        elif isinstance(each, ast.comprehension):
            reads = [each.iter]
        elif isinstance(each, (ast.Return, ast.YieldFrom)) and each.value is not None:
            reads = [each.value]
        yield from (name for name in reads if isinstance(name, ast.Name))


def _tested(node: ast.expr) -> Iterator[ast.Name]:
    """The names that a test or loop asks themselves."""
    if isinstance(node, ast.Name):
        yield node
    elif isinstance(node, ast.BoolOp):
        for each in node.values:
            yield from _tested(each)
    elif isinstance(node, ast.UnaryOp):
        yield from _tested(node.operand)
