"""Questions to the syntax of a rule's functions that need no knowledge of what names are."""

from __future__ import annotations

import ast
from collections.abc import Iterable
from collections.abc import Iterator

from bringup_lint.named_tuple import NamedTuple

SAME_ITEMS = frozenset({"list", "tuple", "set", "frozenset", "sorted", "reversed", "enumerate", "iter"})
_READING = frozenset({"len", "any", "all", "min", "max", "sum", "zip", "next", "dict", "map", "filter", *SAME_ITEMS})
_READING_METHODS = frozenset({"items", "values", "keys", "get"})
_FILLING_METHODS = frozenset({"append", "extend", "insert", "add", "update"})


class Constants(NamedTuple):
    """What a rule file gives names to, outside of its functions."""

    texts: dict[str, str]
    words: dict[str, tuple[str, ...]]
    hints: dict[str, tuple[str, ...]]
    """Name of a pattern in which case counts -> words, one of which is in each text that it matches."""

    @classmethod
    def of(cls, tree: ast.Module) -> Constants:
        given = [pair for node in tree.body for pair in assigned(node)]
        texts = {
            target.id: value.value
            for target, value in given
            if isinstance(value, ast.Constant) and isinstance(value.value, str)
        }
        words = {target.id: words for target, value in given if (words := constant_words(value))}
        hints = {target.id: hints for target, value in given if (hints := _hints(value))}
        return cls(texts, words, hints)


def own(node: ast.AST) -> Iterator[ast.AST]:
    """A node and what is below it, without the functions in it."""
    yield node
    for child in ast.iter_child_nodes(node):
        if not isinstance(child, (ast.FunctionDef, ast.Lambda, ast.ClassDef)):
            yield from own(child)


def assigned(node: ast.AST) -> Iterator[tuple[ast.Name, ast.expr]]:
    """The names that a statement gives values, with these."""
    pairs: list[tuple[ast.expr, ast.expr | None]] = []
    if isinstance(node, ast.Assign) and len(node.targets) == 1:
        target, value = node.targets[0], node.value
        pairs = [(target, value)]
        if isinstance(target, ast.Tuple) and isinstance(value, ast.Tuple) and len(target.elts) == len(value.elts):
            pairs = list(zip(target.elts, value.elts))
    elif isinstance(node, (ast.AnnAssign, ast.NamedExpr)):
        pairs = [(node.target, node.value)]
    for name, given in pairs:
        if isinstance(name, ast.Name) and given is not None:
            yield name, given


def constant_words(node: ast.expr) -> tuple[str, ...]:
    """The words of a list that is written out; none where it holds anything else."""
    items = node.elts if isinstance(node, (ast.Tuple, ast.List, ast.Set)) else []
    words = [each.value for each in items if isinstance(each, ast.Constant) and isinstance(each.value, str)]
    return tuple(words) if len(words) == len(items) else ()


def _hints(value: ast.expr) -> tuple[str, ...]:
    """The hints of a pattern, where they are written out and case counts."""
    if not isinstance(value, ast.Call) or not isinstance(value.func, ast.Name) or value.func.id != "regex":
        return ()
    options = {str(each.arg): each.value for each in value.keywords}
    options.update(zip(("pattern", "flags", "hints"), value.args))
    hints = options.get("hints")
    if not isinstance(hints, ast.Constant) or not isinstance(hints.value, str):
        return ()
    folds = (
        isinstance(each, ast.Attribute) and each.attr in ("I", "IGNORECASE")
        for each in ast.walk(options.get("flags", hints))
    )
    return () if any(folds) else tuple(hints.value.split())


def same_items(node: ast.expr | None) -> ast.expr | None:
    """What a comprehension chooses its items from; None for one that makes others."""
    if not isinstance(node, (ast.ListComp, ast.GeneratorExp, ast.SetComp)) or len(node.generators) != 1:
        return None
    (each,) = node.generators
    is_same = isinstance(node.elt, ast.Name) and isinstance(each.target, ast.Name) and node.elt.id == each.target.id
    return each.iter if is_same else None


def is_filled(function: ast.AST, name: str) -> bool:
    """Whether a function puts items into the list that a name holds."""
    calls = (node.func for node in ast.walk(function) if isinstance(node, ast.Call))
    return any(
        isinstance(each, ast.Attribute)
        and each.attr in _FILLING_METHODS
        and isinstance(each.value, ast.Name)
        and each.value.id == name
        for each in calls
    )


def looped(node: ast.AST) -> Iterator[tuple[ast.expr, ast.expr]]:
    """The targets of loops with what they loop over."""
    if isinstance(node, (ast.For, ast.comprehension)):
        yield node.target, node.iter


def inner_blocks(node: ast.stmt) -> Iterator[list[ast.stmt]]:
    if isinstance(node, ast.Match):
        yield from (case.body for case in node.cases)
    if isinstance(node, (ast.With, ast.Try)):
        yield node.body
    if isinstance(node, ast.Try):
        yield from (handler.body for handler in node.handlers)
        yield node.orelse
        yield node.finalbody


def is_fresh(node: ast.expr) -> bool:
    """Whether an expression makes a list that may be filled later."""
    if isinstance(node, ast.Call):
        return isinstance(node.func, ast.Name)
    return isinstance(node, (ast.List, ast.Dict, ast.Set, ast.ListComp, ast.SetComp, ast.DictComp, ast.BinOp))


def only_read(node: ast.AST) -> Iterator[ast.Name]:
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
        elif isinstance(each, ast.IfExp):
            reads = _tested(each.test)
        elif isinstance(each, ast.Subscript) and isinstance(each.ctx, ast.Load):
            reads = [each.value]
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


def is_rule(node: ast.FunctionDef) -> bool:
    """Whether a function is decorated as a rule."""
    return any(
        isinstance(each, ast.Call) and isinstance(each.func, ast.Name) and each.func.id == "rule"
        for each in node.decorator_list
    )


def is_generator(function: ast.FunctionDef) -> bool:
    """Whether a call of a function gives what it yields, not what it returns."""
    return any(isinstance(node, (ast.Yield, ast.YieldFrom)) for node in own(function))


def asks_for_one(node: ast.expr) -> bool:
    """Whether an expression is the call of a ``get``."""
    return isinstance(node, ast.Call) and isinstance(node.func, ast.Attribute) and node.func.attr == "get"


def takes_plain_arguments(function: ast.FunctionDef, call: ast.Call) -> bool:
    """Whether each argument of a call is the value of one parameter."""
    named = function.args
    plain = not (function.decorator_list or named.vararg or named.kwarg or named.posonlyargs)
    starred = any(isinstance(each, ast.Starred) for each in call.args) or not all(each.arg for each in call.keywords)
    return plain and not starred
