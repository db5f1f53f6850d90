"""Flags that stay set when an action server rejects a goal."""

from __future__ import annotations

import ast
from collections.abc import Iterable
from collections.abc import Iterator
from typing import TYPE_CHECKING
from typing import TypeGuard

from bringup_lint.graph.nodes.sources.callback_code import reached
from bringup_lint.graph.nodes.sources.syntax import Syntax
from bringup_lint.graph.nodes.sources.syntax import body_of
from bringup_lint.graph.nodes.sources.syntax import own
from bringup_lint.graph.nodes.sources.syntax import own_calls
from bringup_lint.model.node_source import NodeClass
from bringup_lint.model.python import called_name
from bringup_lint.model.python import is_self
from bringup_lint.model.python import walk
from bringup_lint.model.python import written
from bringup_lint.named_tuple import NamedTuple

if TYPE_CHECKING:
    from bringup_lint.graph.nodes.nodes import Nodes
    from bringup_lint.model.node_source import NodeSource

_LOGS = frozenset(("get_logger", "debug", "info", "warn", "warning", "error", "fatal", "print", "str", "format"))
"""Calls in the branch of a rejected goal that tell nobody else."""


class StuckFlag(NamedTuple):
    file: NodeSource
    name: str
    """The attribute: ``busy``."""
    branch: ast.If
    """Where a rejected goal ends."""
    set_at: ast.stmt
    """Where the flag becomes true."""
    asked: ast.expr
    """The condition that keeps the node from sending another goal."""


def stuck_flags(nodes: Nodes) -> Iterator[StuckFlag]:
    """Flags that are set for a goal, reset only by what follows its acceptance, and asked before the next one."""
    for file, node in nodes.node_classes:
        if "send_goal_async" in file.source.text and ".accepted" in file.source.text:
            yield from _in_class(nodes, file, node)


def _in_class(nodes: Nodes, file: NodeSource, node: NodeClass) -> Iterator[StuckFlag]:
    syntax = nodes.syntax(file)
    uses: _Uses | None = None
    for name in _told(syntax, node):
        method = node.methods[name].node
        branch = next((each for each in own(body_of(method)) if isinstance(each, ast.If) and _rejects(each)), None)
        if branch is None or _goes_on(branch):
            continue
        after = {each for each in _handed_over(own(body_of(method))) if each in node.methods} - {name}
        reset = {flag for each in own(branch.body) for flag, _ in _assigned(each)}
        later = {each for one in after for each in reached(syntax, body_of(node.methods[one].node), node)}
        uses = uses or _Uses(syntax, node)
        for flag in sorted(_flags(node) - reset - uses.foreign):
            found = _stuck(uses, flag, later)
            if found is not None:
                yield StuckFlag(file, flag, branch, *found)


def _told(syntax: Syntax, node: NodeClass) -> Iterator[str]:
    """The methods that get the answer of a server to a goal: those handed over where one is sent."""
    for name, method in node.methods.items():
        code = list(own(body_of(method.node)))
        sends = any(isinstance(each, ast.Attribute) and each.attr == "send_goal_async" for each in code)
        if name in node.methods and sends:
            yield from dict.fromkeys(each for each in _handed_over(code) if each in node.methods)


def _handed_over(code: Iterable[ast.AST]) -> Iterator[str]:
    """``x`` of ``add_done_callback(self.x)``."""
    for call in code:
        if isinstance(call, ast.Call) and isinstance(call.func, ast.Attribute):
            if call.func.attr == "add_done_callback" and len(call.args) == 1:
                yield from (each.attr for each in walk(call.args[0]) if isinstance(each, ast.Attribute))


def _rejects(node: ast.If) -> bool:
    """``if not handle.accepted:`` with a branch that leaves the function."""
    test = node.test
    is_not = isinstance(test, ast.UnaryOp) and isinstance(test.op, ast.Not) and _is_accepted(test.operand)
    is_false = isinstance(test, ast.Compare) and _is_accepted(test.left) and written(test).endswith("False")
    return (is_not or is_false) and isinstance(node.body[-1], ast.Return)


def _is_accepted(node: ast.expr) -> bool:
    return isinstance(node, ast.Attribute) and node.attr == "accepted"


def _goes_on(branch: ast.If) -> bool:
    """Whether a branch does more than to write to the log: it may set the node right in another way."""
    names = {called_name(call) for call in own_calls(branch.body)}
    return not names <= _LOGS or any(isinstance(each, ast.Raise) for each in own(branch.body))


def _flags(node: NodeClass) -> set[str]:
    """The attributes to which a class assigns only True and False."""
    values: dict[str, set[object]] = {}
    for method in node.methods.values():
        for each in walk(method.node):
            for name, value in _assigned(each):
                values.setdefault(name, set()).add(value.value if isinstance(value, ast.Constant) else None)
    return {name for name, given in values.items() if given == {True, False} and all(v is not None for v in given)}


def _assigned(node: ast.AST) -> Iterator[tuple[str, ast.expr]]:
    if isinstance(node, ast.Assign):
        targets, value = node.targets, node.value
    elif isinstance(node, ast.AnnAssign) and node.value is not None:
        targets, value = [node.target], node.value
    else:
        return
    for target in targets:
        yield from ((each.attr, value) for each in walk(target) if _is_stored(each) and is_self(each.value))


class _Uses:
    """What a class does with its flags and its goals, read once for all flags."""

    def __init__(self, syntax: Syntax, node: NodeClass) -> None:
        self.set: dict[str, list[tuple[str, ast.AST, ast.expr]]] = {}
        """Attribute -> the method, the statement and the value of each assignment outside of the constructor."""
        self.asked: dict[str, ast.expr] = {}
        """Attribute -> the first condition of what leads to a goal that asks for it."""
        self.foreign = {each.attr for each in syntax.file.nodes if _is_stored(each) and not is_self(each.value)}
        """Attributes that something sets on another object than ``self``."""
        self.sending: set[str] = set()
        """The methods that lead to a goal."""
        for name, method in node.methods.items():
            code = list(walk(method.node))
            if _sends(syntax, node, method.node):
                self.sending.add(name)
                self._take_conditions(each.test for each in code if isinstance(each, ast.If) and _holds_back(each))
            if name != "__init__":
                self._take_assignments(str(name), code)

    def _take_assignments(self, method: str, code: Iterable[ast.AST]) -> None:
        for each in code:
            for attribute, value in _assigned(each):
                self.set.setdefault(attribute, []).append((method, each, value))

    def _take_conditions(self, tests: Iterable[ast.expr]) -> None:
        for test in tests:
            for each in walk(test):
                if isinstance(each, ast.Attribute):
                    self.asked.setdefault(each.attr, test)


def _stuck(uses: _Uses, flag: str, later: set[ast.AST]) -> tuple[ast.stmt, ast.expr] | None:
    """Where a flag is set and where it is asked; None unless only what follows the acceptance resets it."""
    set_at: ast.stmt | None = None
    resets = 0
    for name, each, value in uses.set.get(flag, ()):
        if isinstance(value, ast.Constant) and value.value is True:
            set_at = each if isinstance(each, ast.stmt) and name in uses.sending else set_at
        elif each not in later:
            return None
        else:
            resets += 1
    asked = uses.asked.get(flag)
    return (set_at, asked) if set_at is not None and resets and asked is not None else None


def _sends(syntax: Syntax, node: NodeClass, function: ast.AST) -> bool:
    """Whether a method leads to a goal that is sent."""
    code = reached(syntax, body_of(function), node)
    return any(isinstance(each, ast.Attribute) and each.attr == "send_goal_async" for each in code)


def _holds_back(node: ast.If) -> bool:
    """Whether a condition leaves something out while a flag is set; not one that only replaces the goal."""
    is_negative = any(isinstance(each, (ast.UnaryOp, ast.Compare)) for each in walk(node.test))
    return is_negative or bool(node.orelse) or isinstance(node.body[-1], (ast.Return, ast.Raise, ast.Continue))


def _is_stored(node: ast.AST) -> TypeGuard[ast.Attribute]:
    return isinstance(node, ast.Attribute) and isinstance(node.ctx, ast.Store)
