"""Events and flags that a lifecycle node sets when it is deactivated, and that stay so when it is activated again."""

from __future__ import annotations

import ast
from collections.abc import Iterator

from bringup_lint.graph.nodes.sources.callback_code import reached
from bringup_lint.graph.nodes.sources.stored_values import stored
from bringup_lint.graph.nodes.sources.syntax import Syntax
from bringup_lint.graph.nodes.sources.syntax import body_of
from bringup_lint.model.node_source import NodeClass
from bringup_lint.model.python import is_own
from bringup_lint.named_tuple import NamedTuple

_EARLIER = ("__init__", "on_configure", "on_cleanup")
"""What has run before the node is active for the first time, and does not run between deactivate and activate."""
_CHANGES = {"set": True, "clear": False}
_ASKS = ("is_set", "wait")


class StuckSwitch(NamedTuple):
    name: str
    """``self.stop``."""
    switched: ast.expr
    """What stops the loop when the node is deactivated."""
    back: ast.expr | None
    """What alone takes that back, if anything does."""
    loop: ast.While


class _Step(NamedTuple):
    """A change of an event or a flag."""

    place: ast.expr
    attribute: str
    value: bool


def stuck_switches(syntax: Syntax, node: NodeClass) -> Iterator[StuckSwitch]:
    """The loops of a lifecycle node that end at once when it is activated for the second time."""
    left, entered = node.methods.get("on_deactivate"), node.methods.get("on_activate")
    if not node.is_lifecycle or left is None or entered is None:
        return
    loops = [each for each in node.inner if isinstance(each, ast.While)]
    steps = [step for each in node.inner if (step := _step(syntax, node, each)) is not None]
    early = {each for name in _EARLIER if name in node.methods for each in _code(syntax, node, name)}
    late = set(_code(syntax, node, "on_deactivate"))
    for step in steps:
        loop = next((each for each in loops if each not in late and _is_ended(each, step)), None)
        if step.place not in late or loop is None or not _is_known(syntax, node, step.attribute):
            continue
        back = [each for each in steps if each.attribute == step.attribute and each.value != step.value]
        if all(each.place in early and each.place not in late for each in back):
            first = next((each.place for each in back), None)
            yield StuckSwitch(f"self.{step.attribute}", step.place, first, loop)


def _code(syntax: Syntax, node: NodeClass, name: str) -> list[ast.AST]:
    return reached(syntax, body_of(node.methods[name].node), node)


def _step(syntax: Syntax, node: NodeClass, each: ast.AST) -> _Step | None:
    """``self.stop.set()``, or ``self.running = False``."""
    if is_own(each) and isinstance(each.ctx, ast.Store):
        outer = next(syntax.above(each))[0]
        value = outer.value if isinstance(outer, (ast.Assign, ast.AnnAssign)) else None
        if isinstance(value, ast.Call) and syntax.qualified(value) == "threading.Event":
            return _Step(each, each.attr, False)
        is_flag = isinstance(value, ast.Constant) and isinstance(value.value, bool)
        return _Step(each, each.attr, value.value) if is_flag else None  # type: ignore[union-attr]
    if not isinstance(each, ast.Call) or not isinstance(each.func, ast.Attribute):
        return None
    owner, change = each.func.value, _CHANGES.get(each.func.attr)
    return _Step(each, owner.attr, change) if change is not None and is_own(owner) else None


def _is_known(syntax: Syntax, node: NodeClass, name: str) -> bool:
    """Whether an attribute is an event, or a flag that is only ever set to what is written."""
    values = stored(syntax, node, ast.Attribute(ast.Name("self", ast.Load()), name, ast.Load()))
    are_events = [isinstance(each, ast.Call) and syntax.qualified(each) == "threading.Event" for each in values]
    are_flags = [isinstance(each, ast.Constant) and isinstance(each.value, bool) for each in values]
    return bool(values) and (all(are_events) or all(are_flags))


def _is_ended(loop: ast.While, step: _Step) -> bool:
    """Whether a loop does not run while an event or flag has a value."""
    tests = loop.test.values if isinstance(loop.test, ast.BoolOp) and isinstance(loop.test.op, ast.And) else [loop.test]
    return any(_asked(test) == (step.attribute, not step.value) for test in tests)


def _asked(test: ast.expr) -> tuple[str, bool] | None:
    """The event or flag that a condition asks for, and the value for which it holds."""
    if isinstance(test, ast.UnaryOp) and isinstance(test.op, ast.Not):
        inner = _asked(test.operand)
        return (inner[0], not inner[1]) if inner is not None else None
    if isinstance(test, ast.Call) and isinstance(test.func, ast.Attribute) and test.func.attr in _ASKS:
        test = test.func.value
    return (test.attr, True) if is_own(test) else None
