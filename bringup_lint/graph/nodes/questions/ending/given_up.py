"""Constructors of nodes that log an error and return before they have made anything, in Python and in C++."""

from __future__ import annotations

import ast
from collections.abc import Iterator
from itertools import islice
from typing import TYPE_CHECKING

from bringup_lint.graph.nodes.sources.failure_logs import is_failure_log
from bringup_lint.graph.nodes.sources.syntax import Syntax
from bringup_lint.graph.nodes.sources.syntax import own
from bringup_lint.graph.nodes.sources.syntax import own_calls
from bringup_lint.model.cpp_source import GivenUp
from bringup_lint.model.node_source import NodeClass
from bringup_lint.model.python import FunctionNode
from bringup_lint.model.python import called_name
from bringup_lint.model.python import is_own
from bringup_lint.model.python import is_self
from bringup_lint.model.python import walk
from bringup_lint.model.python import written
from bringup_lint.parsers.cpp_node.given_up import STAYS
from bringup_lint.pattern import regex

if TYPE_CHECKING:
    from bringup_lint.graph.nodes.nodes import Nodes

_ENDS = frozenset({"shutdown", "try_shutdown", "exit", "_exit", "quit", "abort", "kill", "destroy_node"})
_MAKES = regex(
    r"create_|\w*(?:Thread|Timer|Server|Client|Listener|Subscriber|Updater|Handler|Executor)\Z|spin|add_\w+_callback"
)
"""What may run something later."""
_PARAMETERS = frozenset({"get_parameter", "declare_parameter"})
_OF_OTHERS = regex(r"(?<!self)\.(\w+)")
_OF_NODES = regex(r"(?:declare_|get_|has_|set_|undeclare_)")
"""The beginnings of methods of a node that make nothing."""


def given_up(nodes: Nodes) -> Iterator[GivenUp]:
    """The first return of each constructor after which its node has neither timer nor topic nor service."""
    for file, cls in nodes.node_classes:
        made = cls.methods.get("__init__")
        if made is None or cls.name is None or cls.base is not None or cls.is_lifecycle or len(cls.bases) != 1:
            continue
        kept = {each.attr for each in own(made.node.body) if is_own(each) and isinstance(each.ctx, ast.Store)}
        if not nodes.syntax(file).once(_asked_in_conditions).isdisjoint((*kept, *cls.methods)):
            continue
        returns = [each for each in own(made.node.body) if isinstance(each, ast.Return)]
        calls = own_calls(made.node.body) if returns else ()
        seen: set[str] = set()
        lost = next((each for each in calls if _may_make(cls, each, seen)), None)
        if lost is not None:
            gives = _GivesUp(nodes.syntax(file), _given(made.node))
            early = (each for each in returns if _at(each) < _at(lost) and gives.at(each))
            set_by = _of_parameters(made.node)
            for each in islice(early, 1):
                is_setting = gives.asks_only(each, set_by)
                yield GivenUp(file.span_of(each), file.span_of(lost), str(cls.name), is_setting)
    for source in nodes.cpp:
        yield from source.given_up


def _given(made: FunctionNode) -> frozenset[str]:
    """The arguments of a constructor, and the attributes that keep them: another start gets the same ones."""
    names = {each.arg for each in (*made.args.args, *made.args.kwonlyargs)}
    kept: set[str] = set()
    for each in own(made.body):
        if isinstance(each, ast.Assign) and isinstance(each.value, ast.Name) and each.value.id in names:
            kept.update(target.attr for target in each.targets if is_own(target))
    return frozenset(names | kept)


def _of_parameters(made: FunctionNode) -> frozenset[str]:
    """The variables and attributes that get the value of a parameter as it is, and nothing else."""
    found: set[str] = set()
    others: set[str] = set()
    for each in own(made.body):
        if isinstance(each, ast.Assign):
            kept = found if _is_read(each.value) else others
            kept.update(name for target in each.targets for name in _names(target))
    return frozenset(found - others)


def _is_read(value: ast.expr) -> bool:
    """Whether an expression is the value of a parameter, and not what a function makes of it."""
    while not (isinstance(value, ast.Call) and called_name(value) in _PARAMETERS):
        if isinstance(value, ast.Attribute):
            value = value.value
        elif isinstance(value, ast.Call) and not value.args and isinstance(value.func, ast.Attribute):
            value = value.func
        else:
            return False
    return is_own(value.func)


def _names(test: ast.expr) -> set[str]:
    """The variables and the own attributes that a condition looks at, and the functions that it calls."""
    parts = list(walk(test))
    selves = {id(each.value) for each in parts if is_own(each)}
    plain = {each.id for each in parts if isinstance(each, ast.Name) and id(each) not in selves}
    return {*plain, *(each.attr for each in parts if isinstance(each, ast.Attribute))}


def _at(node: ast.stmt | ast.expr) -> tuple[int, int]:
    return node.lineno, node.col_offset


def _may_make(cls: NodeClass, call: ast.Call, seen: set[str]) -> bool:
    """Whether a call may make what runs later: itself, in a method that is not ``seen``, or in what is handed the
    node."""
    if is_own(call.func):
        method = cls.methods.get(call.func.attr)
        if call.func.attr in seen:
            return False
        seen.add(call.func.attr)
        if method is not None:
            return any(_MAKES.match(called_name(each)) for each in ast.walk(method.node) if isinstance(each, ast.Call))
        return not _OF_NODES.match(call.func.attr)
    given = [*call.args, *(each.value for each in call.keywords)]
    is_base = called_name(call) == "__init__"
    return _MAKES.match(called_name(call)) is not None or (not is_base and any(map(is_self, given)))


class _GivesUp:
    """Whether the returns of a constructor are in branches that log an error, and leave nothing by which anybody else
    would know."""

    def __init__(self, syntax: Syntax, given: frozenset[str]) -> None:
        self._syntax = syntax
        self._given = given
        self._known: dict[tuple[ast.AST, str], bool] = {}

    def at(self, left: ast.Return) -> bool:
        outer, field = next(self._syntax.above(left))
        if not isinstance(outer, (ast.If, ast.ExceptHandler)):
            return False
        if isinstance(outer, ast.If) and _names(outer.test) <= self._given:
            return False
        if (outer, field) not in self._known:
            self._known[outer, field] = self._in_block(list(own(getattr(outer, field))))
        return self._known[outer, field]

    def asks_only(self, left: ast.Return, names: frozenset[str]) -> bool:
        """Whether a return is in a branch that only some names decide."""
        outer, _ = next(self._syntax.above(left))
        return isinstance(outer, ast.If) and _names(outer.test) <= names

    def _in_block(self, block: list[ast.AST]) -> bool:
        calls = [each for each in block if isinstance(each, ast.Call)]
        said = [written(each) for each in calls if is_failure_log(each)]
        if not said or any(map(STAYS.search, said)) or any(called_name(each) in _ENDS for each in calls):
            return False
        flags = (each.attr for each in block if is_own(each) and isinstance(each.ctx, ast.Store))
        return self._syntax.once(_asked_by_others).isdisjoint(flags)


def _asked_by_others(syntax: Syntax) -> frozenset[str]:
    """The attributes that a file asks of something else than ``self``."""
    return frozenset(_OF_OTHERS.findall(syntax.file.source.text))


def _asked_in_conditions(syntax: Syntax) -> frozenset[str]:
    """What the conditions outside of classes ask of others, such as a node whether it is ready."""
    conditions = [each for each in syntax.file.nodes if isinstance(each, (ast.If, ast.While, ast.IfExp))]
    tests = (
        each.test for each in conditions if not any(isinstance(one, ast.ClassDef) for one, _ in syntax.above(each))
    )
    return frozenset(each.attr for test in tests for each in walk(test) if isinstance(each, ast.Attribute))
