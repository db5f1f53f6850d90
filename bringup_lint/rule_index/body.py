"""What is needed for a function of a rule to give an item or a true value.

A rule yields findings. Around each ``yield`` are loops over lists and tests of values, and where one of the lists is
empty, or one of the values absent, that ``yield`` is not reached.
"""

from __future__ import annotations

import ast
from collections.abc import Iterable
from collections.abc import Iterator
from functools import cached_property

from bringup_lint.rule_index.expressions import ROBOT
from bringup_lint.rule_index.expressions import UNIT
from bringup_lint.rule_index.expressions import Expressions
from bringup_lint.rule_index.expressions import Question
from bringup_lint.rule_index.expressions import Value
from bringup_lint.rule_index.needs import NOTHING
from bringup_lint.rule_index.needs import Needs
from bringup_lint.rule_index.needs import both
from bringup_lint.rule_index.needs import either
from bringup_lint.rule_index.syntax import Constants
from bringup_lint.rule_index.syntax import assigned
from bringup_lint.rule_index.syntax import constant_words
from bringup_lint.rule_index.syntax import inner_blocks
from bringup_lint.rule_index.syntax import is_filled
from bringup_lint.rule_index.syntax import is_fresh
from bringup_lint.rule_index.syntax import is_generator
from bringup_lint.rule_index.syntax import is_rule
from bringup_lint.rule_index.syntax import looped
from bringup_lint.rule_index.syntax import only_read
from bringup_lint.rule_index.syntax import own
from bringup_lint.rule_index.syntax import same_items
from bringup_lint.rule_index.syntax import takes_plain_arguments

_DEEPEST = 6
"""How many calls of a rule's own functions are followed."""
_UNIT_LISTS = frozenset({"judged", "services", "ros", "ros1", "presumed_ros", "dds", "running"})
"""The lists of ``robot.units`` that hold units."""


def needs_of(text: str) -> Needs:
    """What the rule in a file needs."""
    tree = ast.parse(text)
    functions = {node.name: node for node in tree.body if isinstance(node, ast.FunctionDef)}
    rule = next((node for node in functions.values() if is_rule(node)), None)
    if rule is None or [parameter.arg for parameter in rule.args.args] != ["robot"]:
        return NOTHING
    try:
        return Body(rule, {"robot": ROBOT}, functions, Constants.of(tree)).items
    except RecursionError:
        return NOTHING


class Body(Expressions):
    """A function with what its parameters are."""

    def __init__(
        self,
        function: ast.FunctionDef,
        names: dict[str, Value],
        functions: dict[str, ast.FunctionDef],
        constants: Constants,
        depth: int = 0,
    ) -> None:
        super().__init__(names, functions, constants)
        self._function = function
        self._depth = depth
        self._is_generator = is_generator(function)
        self._uses: dict[str, list[Needs]] | None = None
        """Name -> what is needed to get to the places where it is used otherwise than to be read; None before the
        first walk."""
        self._noted: dict[str, list[Needs]] = {}
        self._yielded: list[Needs] = []
        self._returned: list[tuple[ast.expr, Needs]] = []

    @cached_property
    def items(self) -> Needs:
        """What is needed for the call to give an item."""
        self._walk()
        returned = (both(given, self.some(value)) for value, given in self._returned)
        return either(*self._yielded, *([] if self._is_generator else returned))

    @cached_property
    def truth(self) -> Needs:
        """What is needed for the call to give a true value."""
        return self._returns(Expressions.true)

    @cached_property
    def value(self) -> Needs:
        """What is needed for the call to give something else than None."""
        return self._returns(Expressions.given)

    def _returns(self, ask: Question) -> Needs:
        self._walk()
        if self._is_generator:
            return NOTHING
        return either(*(both(given, ask(self, value)) for value, given in self._returned))

    def _walk(self) -> None:
        """Twice: the second time it is known where lists are filled."""
        self._bind()
        for _ in range(2):
            self._yielded, self._returned, self._noted = [], [], {}
            self._block(self._function.body, NOTHING)
            self._uses = self._noted

    def _bind(self) -> None:
        """The names that are given a value once. All others may be anything."""
        stored: dict[str, int] = {}
        for node in ast.walk(self._function):
            if isinstance(node, ast.Name) and not isinstance(node.ctx, ast.Load):
                stored[node.id] = stored.get(node.id, 0) + 1
            elif isinstance(node, (ast.Global, ast.Nonlocal)):
                stored.update(dict.fromkeys(node.names, 2))
        given_again = stored.keys() & self.names.keys()
        for name in given_again:
            del self.names[name]
        once = {name for name, count in stored.items() if count == 1} - given_again
        for node in own(self._function):
            for target, value in assigned(node):
                if target.id in once:
                    self.names[target.id] = Value(value, self)
        lists: dict[str, list[ast.expr]] = {}
        for node in own(self._function):
            for each, listed in looped(node):
                if isinstance(each, ast.Name):
                    lists.setdefault(each.id, []).append(listed)
        for name, each_list in lists.items():
            if len(each_list) == stored[name] and name not in given_again:
                self._bind_looped(name, each_list)

    def _bind_looped(self, name: str, lists: list[ast.expr]) -> None:
        words = [self._words_of(listed) for listed in lists]
        if all(words):
            self.keys[name] = tuple(word for each in words for word in each)
        elif all(map(self._gives_units, lists)):
            self.names[name] = UNIT

    def _words_of(self, listed: ast.expr) -> tuple[str, ...]:
        return self.constants.words.get(listed.id, ()) if isinstance(listed, ast.Name) else constant_words(listed)

    def _gives_units(self, listed: ast.expr) -> bool:
        if isinstance(listed, ast.Name) and not is_filled(self._function, listed.id):
            value = self.names.get(listed.id)
            chosen = same_items(value and value.expression)
            if chosen is not None:
                return self._gives_units(chosen)
        if isinstance(listed, (ast.Tuple, ast.List)):
            return all(isinstance(each, ast.Starred) and self._gives_units(each.value) for each in listed.elts)
        path = self.path(listed)
        if path is None or len(path) != 2 or path[0] != "units":
            return False
        return (path[1] if isinstance(path[1], str) else path[1][0]) in _UNIT_LISTS

    # ``given`` is what is needed to get to a statement; what comes back is needed to get past it, or None.

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
            for inner in inner_blocks(node):
                self._block(inner, given)
            self._note_uses_of_head(node, given)
            return given
        return self._simple(node, given)

    def _simple(self, node: ast.stmt, given: Needs) -> Needs | None:
        self._note_uses(node, given)
        if not isinstance(node, (ast.FunctionDef, ast.ClassDef)):
            for each in own(node):
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
        reading = set(only_read(node))
        for each in ast.walk(node):
            if isinstance(each, ast.Name) and isinstance(each.ctx, ast.Load) and each not in reading:
                self._noted.setdefault(each.id, []).append(given)

    def _note_uses_of_head(self, node: ast.stmt, given: Needs) -> None:
        inner = {each for block in inner_blocks(node) for statement in block for each in ast.walk(statement)}
        for each in ast.walk(node):
            if isinstance(each, ast.Name) and isinstance(each.ctx, ast.Load) and each not in inner:
                self._noted.setdefault(each.id, []).append(given)

    def filled(self, name: str, value: Value) -> Iterator[Needs]:
        if value.body is not self or self._uses is None:
            yield NOTHING
        else:
            yield from self._uses.get(name, ())

    def of_function(self, call: ast.Call, function: ast.FunctionDef, ask: Question) -> Needs:
        if self._depth >= _DEEPEST or not takes_plain_arguments(function, call):
            return NOTHING
        values = {each.arg: self._value(given) for each, given in zip(function.args.args, call.args, strict=False)}
        values.update((str(each.arg), self._value(each.value)) for each in call.keywords)
        body = Body(function, values, self.functions, self.constants, self._depth + 1)
        if ask is Expressions.some:
            return body.items
        return body.truth if ask is Expressions.true else body.value

    def _value(self, node: ast.expr) -> Value:
        """What is given to a parameter."""
        if isinstance(node, ast.Name):
            value = self.names.get(node.id, Value(node, self))
            return Value(node, self) if value.expression is not None and is_fresh(value.expression) else value
        return Value(node, self)
