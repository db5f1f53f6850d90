"""Local names of Python functions that are used before anything gives them a value."""

from __future__ import annotations

import ast
import re
from collections.abc import Iterator
from functools import cached_property

from bringup_lint.graph.nodes.sources.idle import is_idle
from bringup_lint.graph.nodes.sources.idle import is_late
from bringup_lint.graph.nodes.sources.syntax import COMPREHENSIONS
from bringup_lint.graph.nodes.sources.syntax import FUNCTIONS
from bringup_lint.graph.nodes.sources.syntax import Syntax
from bringup_lint.graph.nodes.sources.syntax import own
from bringup_lint.model.python import FunctionNode
from bringup_lint.model.python import PlacedNode
from bringup_lint.model.python import bound_names
from bringup_lint.model.python import called_name
from bringup_lint.model.python import walk
from bringup_lint.model.python import written
from bringup_lint.named_tuple import NamedTuple
from bringup_lint.pattern import regex

_PLACED = (ast.expr, ast.stmt, ast.alias, ast.excepthandler)
_LOOPS = (ast.For, ast.AsyncFor, ast.While)
_LEAVES = (ast.Return, ast.Raise, ast.Break, ast.Continue)
_SIMPLE = (ast.Expr, ast.Assign, ast.AnnAssign, ast.AugAssign, ast.Return)
_EXPECTED = frozenset({"NameError", "UnboundLocalError"})
_CAUGHT = frozenset({*_EXPECTED, "Exception", "BaseException"})
_AT_END = frozenset({"KeyboardInterrupt", "SystemExit", "ExternalShutdownException", "ImportError"})
"""Exceptions that come at the end of the program, or before it can do anything."""
_MISTAKES = frozenset({"TypeError", "AttributeError", "NameError", "AssertionError", "NotImplementedError"})
"""Exceptions that only a mistake in the code raises: a handler of them hardly ever runs."""
_NEVER_RAISES = ("FileStorage", "VideoCapture")
"""OpenCV says of what it cannot open only that it is not open."""
_ENDS = regex(r"(?i)\w{0,40}(?:exit|quit|abort|shutdown|fail|die|terminate|raise|skip|kill)")
"""Words of calls after which what follows does not run, or does not matter."""
_LOGGER = regex(r"log|console", re.I, "log console")
"""What has a method error() that only says something; that of a parser of arguments ends the program."""
_ASKS_LENGTH = ("empty", "qsize")

_MACHINES = (frozenset({"x86_64", "amd64"}), frozenset({"aarch64", "arm64"}))
"""The architectures that ROS 2 has packages for, under each of their names."""
_FOLLOWED = 200
"""Statements after a ``try`` or ``if`` that are looked at."""


class Unbound(NamedTuple):
    name: ast.Name
    function: str
    bound_at: PlacedNode
    """Where it gets its value: later in the function, or in the ``try`` that failed."""
    without: ast.ExceptHandler | ast.If | None
    """The handler that goes on without it, or the condition that alone gives it a value; None: it never has one."""
    is_global: bool
    """The file has a name of this kind."""
    caught: bool
    idle: bool


class _Steps(NamedTuple):
    """What a statement does that comes after one which may not give a name its value."""

    leaves_inside: bool
    """A statement or call in it leaves the function, or may end the program."""
    uses: list[ast.Name]
    """What it surely reads."""


def unbound_locals(syntax: Syntax) -> Iterator[Unbound]:
    """The first such use of each name in a function."""
    for function in syntax.file.nodes:
        if isinstance(function, (ast.FunctionDef, ast.AsyncFunctionDef)):
            locals_ = _Locals(syntax, function)
            seen: set[str] = set()
            for found in (*locals_.too_early(), *locals_.after_failures(), *locals_.after_choices()):
                if found.name.id not in seen:
                    seen.add(found.name.id)
                    yield found


class _Locals:
    """The names that one function binds, and where."""

    def __init__(self, syntax: Syntax, function: FunctionNode) -> None:
        self._syntax = syntax
        self._function = function
        self._nodes = list(own(function.body))
        inner = {part for each in self._nodes if isinstance(each, COMPREHENSIONS) for part in walk(each)}
        self._names = [each for each in self._nodes if isinstance(each, ast.Name) and each not in inner]
        self._known: dict[ast.stmt, _Steps] = {}
        self._only_bound: dict[tuple[ast.stmt, str], bool] = {}
        self._bound: dict[str, list[PlacedNode]] = {}
        for each in self._nodes:
            if isinstance(each, _PLACED) and each not in inner:
                for name in bound_names(each):
                    self._bound.setdefault(name, []).append(each)
        unplaced = (each for each in self._nodes if not isinstance(each, (*_PLACED, ast.comprehension)))
        arguments = {name for each in (*walk(function.args), *unplaced) for name in bound_names(each)}
        others = (each.names for each in self._nodes if isinstance(each, (ast.Global, ast.Nonlocal)))
        for name in (*arguments, *(name for names in others for name in names)):
            self._bound.pop(name, None)

    def too_early(self) -> Iterator[Unbound]:
        """Uses that no binding of their name can come before."""
        for use in self._names:
            bindings = self._bound.get(use.id, ()) if isinstance(use.ctx, (ast.Load, ast.Store)) else ()
            if not bindings or not self._is_read(use) or self._is_expected(use) or self._syntax.is_dead(use):
                continue
            if not any(self._may_precede(each, use) for each in bindings):
                yield self._found(use, bindings[0], None)

    def _is_read(self, use: ast.Name) -> bool:
        """``x += 1`` reads what it stores."""
        if isinstance(use.ctx, ast.Load):
            return True
        outer = next(self._syntax.above(use))[0]
        return isinstance(outer, ast.AugAssign)

    def _is_expected(self, use: ast.Name) -> bool:
        return self._syntax.catches(use, _EXPECTED)

    def _may_precede(self, binding: ast.AST, use: ast.Name) -> bool:
        """Whether a binding may run before a use: it is written before it, or a loop goes round both."""
        ours, theirs = self._statement(use), self._statement(binding)
        if ours is theirs:
            return not isinstance(ours, (ast.Assign, ast.AnnAssign, ast.AugAssign)) or self._is_walrus(binding)
        if (theirs.lineno, theirs.col_offset) < (ours.lineno, ours.col_offset):
            return True
        around = {outer for outer, _ in self._syntax.within(binding) if isinstance(outer, _LOOPS)}
        return any(outer in around for outer, _ in self._syntax.within(use))

    def _is_walrus(self, binding: ast.AST) -> bool:
        return isinstance(next(self._syntax.above(binding))[0], ast.NamedExpr)

    def _statement(self, node: ast.AST) -> ast.stmt:
        if isinstance(node, ast.stmt):
            return node
        return next(outer for outer, _ in self._syntax.above(node) if isinstance(outer, ast.stmt))

    def after_failures(self) -> Iterator[Unbound]:
        """Uses after a ``try`` that alone gives a name its value, when a handler of it goes on."""
        for statement in self._nodes:
            if isinstance(statement, ast.Try):
                handler = next((each for each in statement.handlers if self._goes_on(each)), None)
                if handler is not None and not self._is_never_empty(statement, handler):
                    inside = {part for each in statement.body for part in walk(each)}
                    made = {name: at for each in statement.body for name, at in self._made(each, statement, inside)}
                    yield from self._behind(statement, made, handler)

    def _is_never_empty(self, statement: ast.Try, handler: ast.ExceptHandler) -> bool:
        """Whether a loop asks the queue that is read whether it is empty, before each turn."""
        loop, _ = next(self._syntax.above(statement))
        if not isinstance(loop, ast.While) or handler.type is None:
            return False
        asks = any(isinstance(each, ast.Attribute) and each.attr in _ASKS_LENGTH for each in walk(loop.test))
        return asks and written(handler.type).rpartition(".")[2] == "Empty"

    def after_choices(self) -> Iterator[Unbound]:
        """Uses after an ``if`` without ``else`` that alone gives a name its value, in each of its branches; one after
        the other may be all that there are, and so may several."""
        for statement in self._nodes:
            if isinstance(statement, ast.If) and self._is_open(statement):
                branches = _branches(statement)
                if branches is None or (len(branches) > 1 and not self._has_others(statement)):
                    continue
                if _is_whole(self._syntax, statement):
                    continue
                inside = [{part for each in branch for part in walk(each)} for branch in branches]
                made = dict(self._made_in(set().union(*inside)))
                for branch in inside[1:]:
                    bound = {name for each in branch if isinstance(each, _PLACED) for name in bound_names(each)}
                    made = {name: at for name, at in made.items() if name in bound}
                yield from self._behind(statement, made, statement)

    def _is_open(self, choice: ast.If) -> bool:
        """Whether a condition is alone, outside of loops, and may be false."""
        outer, name = next(self._syntax.above(choice))
        block = getattr(outer, name)
        place = block.index(choice)
        is_next = place > 0 and isinstance(block[place - 1], ast.If)
        is_call = isinstance(choice.test, ast.Call) and self._syntax.qualified(choice.test) == "rclpy.ok"
        is_elif = isinstance(outer, ast.If) and name == "orelse"
        return not (is_next or is_call or is_elif or isinstance(choice.test, ast.Constant) or self._is_in_loop(choice))

    def _made_in(self, inside: set[ast.AST]) -> Iterator[tuple[str, PlacedNode]]:
        """The names that nothing binds but statements inside of one."""
        names = {name for each in inside if isinstance(each, _PLACED) for name in bound_names(each)}
        for name in sorted(names & self._bound.keys()):
            bindings = self._bound[name]
            if all(each in inside for each in bindings):
                yield name, bindings[0]

    def _is_in_loop(self, node: ast.AST) -> bool:
        return any(isinstance(outer, _LOOPS) for outer, _ in self._syntax.within(node))

    def _goes_on(self, handler: ast.ExceptHandler) -> bool:
        named = [getattr(each, "id", None) or getattr(each, "attr", None) for each in walk(handler.type or ast.Pass())]
        if not _AT_END.isdisjoint(named):
            return False
        return not any(self._leaves(each) for each in walk(handler))

    def _leaves(self, node: ast.AST) -> bool:
        if isinstance(node, _LEAVES):
            return True
        name = called_name(node) if isinstance(node, ast.Call) else ""
        if name in self._syntax.once(_raising) or _ENDS.match(name):
            return True
        return (
            name == "error"
            and isinstance(node, ast.Call)
            and not any(_LOGGER.search(word) for each in walk(node.func) for word in _words(each))
        )

    def _behind(
        self, statement: ast.stmt, made: dict[str, PlacedNode], without: ast.ExceptHandler | ast.If
    ) -> Iterator[Unbound]:
        """The first use of names that a statement alone gives a value, in the statements after it."""
        if not made:
            return
        for following in self._syntax.after(statement)[:_FOLLOWED]:
            steps = self._steps(following)
            if steps.leaves_inside:
                return
            use = next((each for each in steps.uses if each.id in made), None)
            if use is not None:
                yield self._found(use, made[use.id], without)
            if use is not None or self._leaves(following):
                return
            for name in self._bound_again.get(following, ()):
                made.pop(name, None)

    def _steps(self, statement: ast.stmt) -> _Steps:
        if statement not in self._known:
            leaves = any(self._leaves(each) for each in own([statement]) if each is not statement)
            self._known[statement] = _Steps(leaves, [] if leaves else list(self._certain(statement)))
        return self._known[statement]

    def _made(self, part: ast.stmt, statement: ast.Try, inside: set[ast.AST]) -> Iterator[tuple[str, PlacedNode]]:
        """The names that a part of a ``try`` gives the result of a call which may fail, and that nothing before the end
        of the statement binds elsewhere."""
        if not isinstance(part, ast.Assign) or not any(_may_fail(each) for each in walk(part.value)):
            return
        for target in part.targets:
            if isinstance(target, ast.Name) and self._is_only_bound(target.id, statement, inside):
                yield target.id, target

    def _is_only_bound(self, name: str, statement: ast.Try, inside: set[ast.AST]) -> bool:
        if (statement, name) not in self._only_bound:
            end = statement.end_lineno or statement.lineno
            bindings = self._bound.get(name, [statement])
            self._only_bound[statement, name] = all(each in inside or each.lineno > end for each in bindings)
        return self._only_bound[statement, name]

    @cached_property
    def _bound_again(self) -> dict[ast.stmt, set[str]]:
        """Statement -> the names that it, or a part of it, binds."""
        found: dict[ast.stmt, set[str]] = {}
        for name, places in self._bound.items():
            for place in places:
                for outer in (place, *(outer for outer, _ in self._syntax.within(place))):
                    if isinstance(outer, ast.stmt):
                        found.setdefault(outer, set()).add(name)
        return found

    def _certain(self, statement: ast.stmt) -> Iterator[ast.Name]:
        """The uses of a statement that run whenever it does, in the order of the text."""
        head = statement if isinstance(statement, _SIMPLE) else _head(statement)
        if head is None:
            return
        parts = list(walk(head))
        left_out = {part for each in parts for part in _left_out(each)}
        names = (each for each in parts if isinstance(each, ast.Name) and each not in left_out)
        yield from (each for each in names if isinstance(each.ctx, ast.Load))

    def _found(self, use: ast.Name, bound_at: PlacedNode, without: ast.ExceptHandler | ast.If | None) -> Unbound:
        return Unbound(
            use,
            self._function.name,
            bound_at,
            without,
            is_global=_is_of_file(self._syntax, use.id),
            caught=self._syntax.catches(use, _CAUGHT),
            idle=is_idle(self._syntax, use) or is_late(self._syntax, use) or _hardly_runs(without),
        )

    def _has_others(self, choice: ast.If) -> bool:
        """Whether another chain of the file that compares the same has an ``else`` which goes on."""
        handled = self._syntax.once(_handled)
        return isinstance(choice.test, ast.Compare) and written(choice.test.left) in handled


def _chain(choice: ast.If) -> list[ast.If]:
    """An ``if`` and all its ``elif``."""
    chain = [choice]
    while len(chain[-1].orelse) == 1 and isinstance(chain[-1].orelse[0], ast.If):
        chain.append(chain[-1].orelse[0])
    return chain


def _branches(choice: ast.If) -> list[list[ast.stmt]] | None:
    """The branches of an ``if`` and of all ``elif`` that do not leave it; None with an ``else``."""
    chain = _chain(choice)
    return None if chain[-1].orelse else [each.body for each in chain]


def _is_whole(syntax: Syntax, choice: ast.If) -> bool:
    """Whether a chain has a branch for each architecture, asks for nothing else, and the file knows of no other."""
    asked = [_compared(each.test) for each in _chain(choice)]
    words = frozenset().union(*(each.words for each in asked if each is not None))
    first = asked[0]
    if first is None or any(each is None or each.subject != first.subject for each in asked):
        return False
    if any(words.isdisjoint(names) for names in _MACHINES):
        return False
    return syntax.once(_compared_words)[first.subject] <= frozenset().union(*_MACHINES)


class _Compared(NamedTuple):
    """``subject == "word"``, ``subject in ("word", "word")``"""

    subject: str
    words: frozenset[str]


def _compared(test: ast.AST) -> _Compared | None:
    """What a condition compares with texts; None where it asks for anything else."""
    if not isinstance(test, ast.Compare) or len(test.ops) != 1:
        return None
    given = test.comparators[0]
    if isinstance(test.ops[0], ast.In) and isinstance(given, (ast.Tuple, ast.List, ast.Set)):
        values = given.elts
    elif isinstance(test.ops[0], ast.Eq):
        values = [given]
    else:
        return None
    words = frozenset(each.value for each in values if isinstance(each, ast.Constant) and isinstance(each.value, str))
    return _Compared(written(test.left), words) if len(words) == len(values) else None


def _compared_words(syntax: Syntax) -> dict[str, set[str]]:
    """What is compared with texts -> all of these in the file."""
    found: dict[str, set[str]] = {}
    for compared in map(_compared, syntax.file.nodes):
        if compared is not None:
            found.setdefault(compared.subject, set()).update(compared.words)
    return found


def _handled(syntax: Syntax) -> frozenset[str]:
    """What the chains of a file compare that have an ``elif`` and an ``else`` which goes on."""
    found: set[str] = set()
    for choice in syntax.file.nodes:
        if isinstance(choice, ast.If) and isinstance(choice.test, ast.Compare):
            last = _chain(choice)[-1]
            if last is not choice and last.orelse and not isinstance(last.orelse[-1], (ast.Raise, ast.Return)):
                found.add(written(choice.test.left))
    return frozenset(found)


def _raising(syntax: Syntax) -> frozenset[str]:
    """The names of the functions of a file that always raise."""
    functions = (each for each in syntax.file.nodes if isinstance(each, (ast.FunctionDef, ast.AsyncFunctionDef)))
    return frozenset(each.name for each in functions if any(isinstance(part, ast.Raise) for part in each.body))


def _words(node: ast.AST) -> Iterator[str]:
    """What a node says by itself."""
    for field in ("id", "attr", "arg", "value"):
        word = getattr(node, field, None)
        if isinstance(word, str):
            yield word


def _may_fail(node: ast.AST) -> bool:
    """Whether an expression is a call, but none that only makes a message."""
    if not isinstance(node, ast.Call):
        return False
    name = written(node.func).rpartition(".")[2]
    if name in _NEVER_RAISES:
        return False
    return bool(node.args or node.keywords) or not name[:1].isupper()


def _left_out(node: ast.AST) -> Iterator[ast.AST]:
    """What an expression may leave out: the rest of ``and`` and ``or``, both values of a choice, functions."""
    parts: list[ast.AST] = []
    if isinstance(node, ast.BoolOp):
        parts = [*node.values[1:]]
    elif isinstance(node, ast.IfExp):
        parts = [node.body, node.orelse]
    elif isinstance(node, (*FUNCTIONS, *COMPREHENSIONS)):
        parts = [node]
    return (part for each in parts for part in walk(each))


def _head(statement: ast.stmt) -> ast.expr | None:
    """What a compound statement computes first."""
    return getattr(statement, "test", None) or getattr(statement, "iter", None)


def _is_of_file(syntax: Syntax, name: str) -> bool:
    tree = syntax.file.tree
    return tree is not None and any(name in bound_names(each) for each in own(tree.body))


def _hardly_runs(without: ast.ExceptHandler | ast.If | None) -> bool:
    """Whether a handler takes nothing but what mistakes in the code raise."""
    kind = without.type if isinstance(without, ast.ExceptHandler) else None
    types = kind.elts if isinstance(kind, ast.Tuple) else [kind]
    return all(isinstance(each, ast.Name) and each.id in _MISTAKES for each in types)
