"""Readings that a Python node publishes without a time stamp."""

from __future__ import annotations

import ast
from collections.abc import Iterator
from typing import TYPE_CHECKING

from bringup_lint.graph.nodes.questions.python.missing_attributes import heirs_of
from bringup_lint.graph.nodes.sources.message_types import message_type
from bringup_lint.graph.nodes.sources.sending import published
from bringup_lint.graph.nodes.sources.syntax import FUNCTIONS
from bringup_lint.graph.nodes.sources.syntax import Syntax
from bringup_lint.model.cpp_source import Unstamped
from bringup_lint.model.node_source import JOINTS
from bringup_lint.model.node_source import TIMED
from bringup_lint.model.node_source import TRANSFORM
from bringup_lint.model.node_source import reports_joints
from bringup_lint.model.python import is_self
from bringup_lint.model.python import walk
from bringup_lint.model.python import written
from bringup_lint.pattern import regex

if TYPE_CHECKING:
    from bringup_lint.graph.nodes.nodes import Nodes

_SENDS = ("publish", "sendTransform")
_CAMERAS = regex(r"\b(?:VideoCapture|[Pp]icamera2?|pyrealsense2|pypylon|depthai|ArducamCamera)\b")
"""What takes pictures: those of another node that are published again show how something works."""
_Uses = dict[ast.AST, dict[str, list["ast.Name | ast.Attribute"]]]
"""Function or class -> name -> where it is used there."""


def unstamped(nodes: Nodes) -> Iterator[list[Unstamped]]:
    """The readings without a stamp, those of one source together."""
    for file in nodes.robot_sources:
        if any(send in file.source.text for send in _SENDS):
            found = list(_in_file(nodes, nodes.syntax(file)))
            if found:
                yield found
    for source in nodes.cpp:
        if source.unstamped:
            yield source.unstamped


def _in_file(nodes: Nodes, syntax: Syntax) -> Iterator[Unstamped]:
    seen: set[ast.AST] = set()
    uses: _Uses = {}
    endpoints = [*(each for cls in syntax.file.classes for each in cls.endpoints), *syntax.file.strays]
    for call in syntax.calls:
        if not isinstance(call.func, ast.Attribute) or call.func.attr not in _SENDS or len(call.args) != 1:
            continue
        made = _made(syntax, call.args[0], uses)
        kind = _unstamped(syntax, made) if made is not None and made not in seen else None
        if made is None or kind is None or not _is_sent(syntax, call, kind):
            continue
        if isinstance(call.args[0], ast.Attribute) and _is_used_outside(nodes, syntax, call, call.args[0].attr):
            continue
        if kind == JOINTS and not reports_joints(endpoints):
            continue
        seen.add(made)
        yield Unstamped(syntax.file.span_of(made), kind, syntax.file.span_of(call))


def _made(syntax: Syntax, value: ast.expr, known: _Uses) -> ast.Call | None:
    """The call that makes a message, when nothing but fields is set between there and its publication."""
    if isinstance(value, ast.Call):
        return value if value.keywords or value.args else None
    scope = syntax.function(value) if isinstance(value, ast.Name) else syntax.definition(value)
    name = _name(value)
    if scope is None or name is None:
        return None
    if scope not in known:
        known[scope] = _uses(scope)
    uses = known[scope].get(name, [])
    values = {each: _assigned(syntax, each) for each in uses if isinstance(each.ctx, ast.Store)}
    makings = [made for made in values.values() if not isinstance(made, ast.Constant) or made.value is not None]
    if len(makings) != 1 or not all(each in values or _is_plain_use(syntax, each) for each in uses):
        return None
    return makings[0] if isinstance(makings[0], ast.Call) else None


def _assigned(syntax: Syntax, target: ast.expr) -> ast.expr | None:
    outer = next(syntax.above(target))[0]
    return outer.value if isinstance(outer, (ast.Assign, ast.AnnAssign)) else None


def _name(value: ast.AST) -> str | None:
    """What a local variable or an attribute of the own object is called."""
    if isinstance(value, ast.Attribute):
        return f"self.{value.attr}" if isinstance(value.value, ast.Name) and value.value.id == "self" else None
    return value.id if isinstance(value, ast.Name) else None


def _uses(scope: ast.AST) -> dict[str, list[ast.Name | ast.Attribute]]:
    found: dict[str, list[ast.Name | ast.Attribute]] = {}
    for each in walk(scope):
        name = _name(each)
        if name is not None and isinstance(each, (ast.Name, ast.Attribute)):
            found.setdefault(name, []).append(each)
    return found


def _is_plain_use(syntax: Syntax, use: ast.AST) -> bool:
    """Whether a place sets a field but the stamp, publishes the message, or asks whether there is one."""
    above = syntax.above(use)
    outer, name = next(above)
    if name == "test" or isinstance(outer, (ast.Compare, ast.BoolOp, ast.UnaryOp)):
        return True
    if isinstance(outer, ast.Attribute):
        further = next(above)[0]
        return outer.attr != "header" or (isinstance(further, ast.Attribute) and further.attr == "frame_id")
    is_sent = isinstance(outer, ast.Call) and name == "args" and isinstance(outer.func, ast.Attribute)
    return is_sent and outer.func.attr in _SENDS  # type: ignore[attr-defined]


def _unstamped(syntax: Syntax, made: ast.Call) -> str | None:
    """The type of a message that is made without its header; None for any other call."""
    given = {each.arg: each.value for each in made.keywords}
    if None in given or ("header" in given and not _is_bare_header(given["header"])):
        return None
    if isinstance(made.func, ast.Attribute) and made.func.attr == "cv2_to_imgmsg":
        return "sensor_msgs/msg/Image" if len(made.args) < 3 and _CAMERAS.search(syntax.file.source.text) else None
    kind = message_type(syntax.qualified(made))
    return kind if kind in TIMED and not made.args else None


def _is_bare_header(value: ast.expr) -> bool:
    """``Header(frame_id=...)``."""
    return isinstance(value, ast.Call) and not value.args and {each.arg for each in value.keywords} <= {"frame_id"}


def _is_sent(syntax: Syntax, call: ast.Call, kind: str) -> bool:
    """Whether a call surely sends: a method of the same name, or of another class, may set the stamp before."""
    if kind == TRANSFORM:
        return _is_moving(syntax, call)
    if published(syntax, call, syntax.class_of(call)) is not None:
        return True
    kept = written(call.func.value) if isinstance(call.func, ast.Attribute) else None
    return any(each.role == "publisher" and each.attribute == kept for each in syntax.file.strays)


def _is_used_outside(nodes: Nodes, syntax: Syntax, call: ast.Call, name: str) -> bool:
    """Whether what has the node, builds on its class or is built on uses an attribute: it may set the stamp."""
    own = syntax.class_of(call)
    if own is None or own.node is None:
        return True
    heirs = heirs_of(nodes)
    family = {*own.lineage, *heirs.get(own, ()), *heirs.get(own.name or "", ())} - {own}
    if any(name in _attributes(each.node) for each in family if each.node is not None):
        return True
    holders = (each for file in nodes.sources if f".{name}" in file.source.text for each in file.nodes)
    return any(isinstance(each, ast.Attribute) and each.attr == name and not is_self(each.value) for each in holders)


def _attributes(node: ast.ClassDef) -> set[str]:
    return {each.attr for each in walk(node) if isinstance(each, ast.Attribute)}


def _is_moving(syntax: Syntax, call: ast.Call) -> bool:
    """Whether a transform goes to a broadcaster which is not that of transforms that never change."""
    if not isinstance(call.func, ast.Attribute) or call.func.attr != "sendTransform":
        return False
    kind = syntax.file.named(call.func.value, syntax.function(call)) or ""
    if kind.rpartition(".")[2] != "TransformBroadcaster":
        return False
    return "static" not in written(call.func.value).lower() and "Static" not in _around(syntax, call)


def _around(syntax: Syntax, call: ast.Call) -> str:
    """The text of the class that a call is in, or of its function."""
    scopes = [outer for outer, _ in syntax.above(call) if isinstance(outer, (*FUNCTIONS, ast.ClassDef))]
    return syntax.file.span_of(scopes[-1]).text if scopes else ""
