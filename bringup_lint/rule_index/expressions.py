"""What is needed for an expression of a rule to have an item, to be true or to be false.

What is not understood counts as given, so that a rule is never taken for silent that could speak.
"""

from __future__ import annotations

import ast
from abc import ABC
from abc import abstractmethod
from collections.abc import Callable
from collections.abc import Iterator

from bringup_lint.named_tuple import NamedTuple
from bringup_lint.rule_index.needs import NEVER
from bringup_lint.rule_index.needs import NOTHING
from bringup_lint.rule_index.needs import Needs
from bringup_lint.rule_index.needs import Path
from bringup_lint.rule_index.needs import any_of
from bringup_lint.rule_index.needs import both
from bringup_lint.rule_index.needs import either
from bringup_lint.rule_index.needs import one
from bringup_lint.rule_index.syntax import SAME_ITEMS
from bringup_lint.rule_index.syntax import Constants
from bringup_lint.rule_index.syntax import asks_for_one
from bringup_lint.rule_index.syntax import is_fresh

_KEYED = frozenset({"get", "flag", "has", "values", "words", "assignments", "seconds", "naming"})
"""Methods of a unit that give nothing for a key that it does not set."""
_NEEDED: dict[Path, Needs] = {
    ("devices", "meant_by"): one("true", (("of_kind", "udev-rules"),)),
    ("devices", "untagged"): one("true", (("of_kind", "udev-rules"),)),
    ("ros", "of"): one("some", ("ros", "settings")),
    ("units", "environment_files"): one("key", "EnvironmentFile"),
}
"""Methods that give nothing without this, whatever they are asked for."""
_OF_SETTINGS = {
    "hidden_home": ("ProtectHome",),
    "memory": (),
    "paths": (),
}
"""Functions that give nothing for a unit without a setting: one of these, or the one that they are asked for."""
_OF_ITEMS = {"missing_settings": 1}
"""Functions that give nothing for an empty list, and which of their arguments this is."""
_FRESH = frozenset({"list", "dict", "set", "defaultdict", "Counter", "sorted"})


class Value(NamedTuple):
    """What a name is: an expression in a body, or the robot, or a unit."""

    expression: ast.expr | None
    body: Expressions | None


ROBOT = Value(None, None)
UNIT = Value(None, None)
"""Compared by identity."""


class Expressions(ABC):
    """The expressions of one function, with what its names are."""

    def __init__(self, names: dict[str, Value], functions: dict[str, ast.FunctionDef], constants: Constants) -> None:
        self.names = names
        self.functions = functions
        self.constants = constants
        self.keys: dict[str, tuple[str, ...]] = {}
        """The names that stand for one of some words."""
        self._asked: set[str] = set()

    @abstractmethod
    def filled(self, name: str, value: Value) -> Iterator[Needs]:
        """What is needed where something may be put into a list that a name holds."""

    @abstractmethod
    def of_function(self, call: ast.Call, function: ast.FunctionDef, ask: Question) -> Needs:
        """The answer to a question for the call of one of the rule's own functions."""

    def path(self, node: ast.expr) -> Path | None:
        """The way from the robot to a value; None for a value that is no plain part of it."""
        if isinstance(node, ast.Name):
            value = self.names.get(node.id)
            if value is None or value is UNIT:
                return None
            return () if value.expression is None or value.body is None else value.body.path(value.expression)
        if isinstance(node, ast.Attribute):
            base = self.path(node.value)
            return None if base is None else (*base, node.attr)
        if isinstance(node, ast.Call) and isinstance(node.func, ast.Attribute) and not node.keywords:
            base = self.path(node.func.value)
            words = self._plain_words(node.args)
            if base is not None and words:
                return (*base, (node.func.attr, *words))
        return None

    def _plain_words(self, arguments: list[ast.expr]) -> tuple[str, ...]:
        """The words that a call is given; none where one of them is not known."""
        words: list[str] = []
        for each in arguments:
            if isinstance(each, ast.Constant) and isinstance(each.value, str):
                words.append(each.value)
            elif isinstance(each, ast.Name) and each.id in self.constants.texts and each.id not in self.names:
                words.append(self.constants.texts[each.id])
            elif isinstance(each, ast.Starred) and isinstance(each.value, ast.Name):
                named = self.constants.words.get(each.value.id, ()) if each.value.id not in self.names else ()
                if not named:
                    return ()
                words += named
            else:
                return ()
        return tuple(words)

    def some(self, node: ast.expr) -> Needs:
        """What is needed for an expression to have an item."""
        path = self.path(node)
        if path:
            return one("some", path)
        if isinstance(node, ast.Name):
            return self._of_name(node, Expressions.some)
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
            return self._called(node, Expressions.some)
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

    def _of_name(self, node: ast.Name, ask: Question) -> Needs:
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
        return either(needs, *self.filled(node.id, value)) if is_fresh(value.expression) else needs

    def _called(self, node: ast.Call, ask: Question) -> Needs:
        function = node.func
        if isinstance(function, ast.Name) and function.id in self.functions:
            return self.of_function(node, self.functions[function.id], ask)
        if isinstance(function, ast.Name) and function.id in SAME_ITEMS and len(node.args) == 1:
            return self.some(node.args[0])
        if isinstance(function, ast.Name) and function.id in _FRESH and not node.args:
            return NEVER if not node.keywords else NOTHING
        if isinstance(function, ast.Name) and function.id == "defaultdict":
            return NEVER if len(node.args) == 1 else NOTHING
        if isinstance(function, ast.Attribute) and function.attr in ("items", "values", "keys") and not node.args:
            return self.some(function.value)
        if isinstance(function, ast.Attribute) and function.attr == "fromkeys" and node.args:
            return self.some(node.args[0])
        if isinstance(function, ast.Name) and function.id in _OF_SETTINGS:
            return self._set(node, _OF_SETTINGS[function.id])
        if isinstance(function, ast.Attribute) and len(node.args) > _OF_ITEMS.get(function.attr, len(node.args)):
            return self.some(node.args[_OF_ITEMS[function.attr]])
        return self._asked_of(node)

    def _first(self, node: ast.expr) -> ast.expr | None:
        """What ``next(each, None)`` takes its first item from."""
        if not isinstance(node, ast.Call) or not isinstance(node.func, ast.Name) or node.func.id != "next":
            return None
        ends_with_none = len(node.args) == 2 and isinstance(node.args[1], ast.Constant) and node.args[1].value is None
        return node.args[0] if ends_with_none else None

    def _asked_of(self, node: ast.Call) -> Needs:
        """What is needed for a question to a unit, or to a part of the robot, to be answered."""
        asked = self.path(node.func) or ()
        if asked[-1:] == ("mentions",) and node.args and isinstance(node.args[0], ast.Name):
            hints = self.constants.hints.get(node.args[0].id)
            return one("true", (("may_hold", *hints),)) if hints else NOTHING
        needed = _NEEDED.get(asked, self._variable(node))
        return self._keys(node) if needed is None else needed

    def _variable(self, node: ast.expr) -> Needs | None:
        """What is needed for an environment to hold the variable that is asked for: a file sets it. None for another
        question."""
        if not isinstance(node, ast.Call) or not isinstance(node.func, ast.Attribute) or len(node.args) != 1:
            return None
        if node.func.attr not in ("get", "text") or not self._is_environment(node.func.value):
            return None
        (asked,) = node.args
        names = self.keys.get(asked.id, ()) if isinstance(asked, ast.Name) else self._plain_words([asked])
        return one("true", (("may_hold", *names),)) if names else NOTHING

    def _is_environment(self, node: ast.expr) -> bool:
        value = self.names.get(node.id) if isinstance(node, ast.Name) else None
        node = value.expression or node if value else node
        return isinstance(node, ast.Attribute) and node.attr == "environment"

    def _keys(self, node: ast.expr) -> Needs:
        """What is needed for a question to a unit to be answered."""
        if not isinstance(node, ast.Call) or not isinstance(node.func, ast.Attribute) or not self._is_unit(node.func):
            return NOTHING
        if node.func.attr in _KEYED and node.args and isinstance(node.args[0], ast.Name):
            return any_of("key", self.keys[node.args[0].id]) if node.args[0].id in self.keys else NOTHING
        words = [each.value for each in node.args if isinstance(each, ast.Constant) and isinstance(each.value, str)]
        if node.func.attr not in _KEYED or not words or not isinstance(node.args[0], ast.Constant):
            return NOTHING
        if node.func.attr != "seconds":
            return one("key", words[0])
        if len(words) != len(node.args):
            return NOTHING
        return any_of("key", words)

    def _set(self, node: ast.Call, keys: tuple[str, ...]) -> Needs:
        """What is needed for a function to find a setting of the unit that it is given."""
        if not node.args or not self._stands_for_unit(node.args[0]):
            return NOTHING
        asked = node.args[1] if len(node.args) > 1 else None
        if not keys and isinstance(asked, ast.Name):
            keys = self.keys.get(asked.id, ())
        elif not keys and isinstance(asked, ast.Constant) and isinstance(asked.value, str):
            keys = (asked.value,)
        return any_of("key", keys) if keys else NOTHING

    def _is_unit(self, node: ast.Attribute) -> bool:
        """Whether an attribute is one of a unit."""
        return self._stands_for_unit(node.value)

    def _stands_for_unit(self, node: ast.expr) -> bool:
        value = self.names.get(node.id) if isinstance(node, ast.Name) else None
        if value is None or value is UNIT:
            return value is not None
        return isinstance(value.expression, ast.Attribute) and value.expression.attr == "unit"

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
            return one("true", path)
        if isinstance(node, ast.Name):
            return self._of_name(node, Expressions.true)
        if isinstance(node, (ast.List, ast.Tuple, ast.Set, ast.Dict, ast.ListComp, ast.SetComp, ast.DictComp)):
            return self.some(node)
        if isinstance(node, ast.IfExp):
            chosen = both(self.true(node.test), self.true(node.body))
            return either(chosen, both(self.false(node.test), self.true(node.orelse)))
        if isinstance(node, ast.Attribute) and node.attr in ("at", "value"):
            return self.given(node.value)
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
        first = self._first(node)
        if first is not None:
            return self.some(first)
        return self._called(node, Expressions.true)

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
            return self.given(left) if isinstance(operator, ast.IsNot if holds else ast.Is) else NOTHING
        if not equal:
            return NOTHING
        if isinstance(operator, (ast.In, ast.NotIn)) and isinstance(right, ast.Name):
            return self.some(right)
        words = right.elts if isinstance(right, (ast.Tuple, ast.List, ast.Set)) else [right]
        if not all(isinstance(each, ast.Constant) and isinstance(each.value, str) for each in words):
            return NOTHING
        if isinstance(operator, (ast.In, ast.NotIn)) and isinstance(right, ast.Constant):
            return NOTHING
        if isinstance(left, ast.Attribute) and left.attr in ("type", "manager") and self._is_unit(left):
            return any_of(left.attr, (each.value for each in words if isinstance(each, ast.Constant)))
        return self.given(left)

    def given(self, node: ast.expr) -> Needs:
        """What is needed for a value not to be None, such as a setting of a unit."""
        if isinstance(node, ast.NamedExpr):
            return self.given(node.value)
        if isinstance(node, ast.Attribute) and node.attr in ("at", "value"):
            return self.given(node.value)
        if isinstance(node, ast.Name):
            value = self.names.get(node.id)
            if value is None or value.expression is None or value.body is None:
                return NOTHING
            return value.body.given(value.expression)
        if isinstance(node, ast.IfExp):
            chosen = both(self.true(node.test), self.given(node.body))
            return either(chosen, both(self.false(node.test), self.given(node.orelse)))
        if isinstance(node, ast.Constant):
            return NEVER if node.value is None else NOTHING
        if isinstance(node, ast.Call) and isinstance(node.func, ast.Name) and node.func.id in self.functions:
            return self.of_function(node, self.functions[node.func.id], Expressions.given)
        if isinstance(node, ast.Call) and self.path(node.func) in _NEEDED:
            return self._asked_of(node)
        first = self._first(node)
        if first is not None:
            return self.some(first)
        if isinstance(node, ast.Call) and isinstance(node.func, ast.Name) and node.func.id in _OF_SETTINGS:
            return self._set(node, _OF_SETTINGS[node.func.id])
        needed = self._variable(node)
        if needed is not None:
            return needed
        return self._keys(node) if asks_for_one(node) else NOTHING


Question = Callable[[Expressions, ast.expr], Needs]
"""``Expressions.some``, ``Expressions.true`` or ``Expressions.given``."""
