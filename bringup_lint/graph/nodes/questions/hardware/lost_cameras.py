"""Cameras whose loss a Python node survives without opening them again."""

from __future__ import annotations

import ast
from collections.abc import Iterator
from typing import TYPE_CHECKING

from bringup_lint.facts.ros.cameras import LOOKED_AFTER
from bringup_lint.facts.ros.cameras import VIDEO_FILE
from bringup_lint.graph.nodes.sources.ending import Ending
from bringup_lint.graph.nodes.sources.syntax import Syntax
from bringup_lint.graph.nodes.sources.syntax import own
from bringup_lint.model.node_source import NodeSource
from bringup_lint.model.python import FunctionNode
from bringup_lint.model.python import called_name
from bringup_lint.model.python import walk
from bringup_lint.model.python import written
from bringup_lint.named_tuple import NamedTuple

if TYPE_CHECKING:
    from bringup_lint.graph.nodes.nodes import Nodes

_CAPTURE = "cv2.VideoCapture"
_LOGS = frozenset({"info", "warn", "warning", "error", "debug", "fatal", "print", "get_logger"})
_WAITS = frozenset({"sleep", "waitKey", "spin_once"})
_STARTS = ("__init__", "main")
_LEAVES = (ast.Return, ast.Continue, ast.Pass)
_LOOPS = (ast.While, ast.For, ast.AsyncFor)


class LostCamera(NamedTuple):
    file: NodeSource
    call: ast.Call
    """The read that fails from then on."""
    opened: ast.Call
    function: str
    choice: ast.If
    """What goes on without a picture."""
    is_logged: bool


def lost_cameras(nodes: Nodes) -> Iterator[LostCamera]:
    """The reads that are tried again and again after a camera is gone, where nothing opens it anew."""
    for file in nodes.robot_sources:
        if "VideoCapture" in file.source.text and not file.source.matches(LOOKED_AFTER):
            ending = nodes.ending(file)
            found = (_lost(ending, call) for call in ending.syntax.calls)
            yield from (each for each in found if each is not None)


def _lost(ending: Ending, call: ast.Call) -> LostCamera | None:
    syntax = ending.syntax
    flag, function = _flag(syntax, call), syntax.function(call)
    if flag is None or function is None or not _repeats(ending, call, function):
        return None
    camera = written(call.func.value)  # type: ignore[attr-defined]
    openings = syntax.once(_openings).get(camera, [])
    if not openings or not all(_opens_device(syntax, each) for _, each in openings):
        return None
    if any(_opens_again(syntax, place, call) for place, _ in openings):
        return None
    choice = _choice(syntax, function, flag)
    branch = _without_picture(syntax, choice, flag) if choice is not None else None
    if choice is None or branch is None or not all(map(_goes_on, branch)):
        return None
    opened = next(each for _, each in openings if isinstance(each, ast.Call))
    return LostCamera(ending.file, call, opened, function.name, choice, any(map(_is_log, branch)))


def _flag(syntax: Syntax, call: ast.Call) -> str | None:
    """``ok`` of ``ok, frame = camera.read()``."""
    if not isinstance(call.func, ast.Attribute) or call.func.attr != "read" or call.args:
        return None
    outer = next(syntax.above(call))[0]
    target = outer.targets[0] if isinstance(outer, ast.Assign) else None
    first = target.elts[0] if isinstance(target, ast.Tuple) and len(target.elts) == 2 else None
    return first.id if isinstance(first, ast.Name) else None


def _repeats(ending: Ending, call: ast.Call, function: FunctionNode) -> bool:
    """Whether a read is in a loop that goes on, or in the callback of a timer."""
    if any(isinstance(outer, ast.While) for outer, _ in ending.syntax.within(call)):
        return True
    callbacks = (each for cls in ending.file.classes for each in cls.callbacks)
    return any(each.role == "timer" and each.name == function.name for each in callbacks)


def _openings(syntax: Syntax) -> dict[str, list[tuple[ast.AST, ast.expr | None]]]:
    """What is opened, as it is written -> the places that give it a value but None, each with the value."""
    found: dict[str, list[tuple[ast.AST, ast.expr | None]]] = {}
    for node in syntax.file.nodes:
        if isinstance(node, (ast.Name, ast.Attribute)) and isinstance(node.ctx, ast.Store):
            outer = next(syntax.above(node))[0]
            value = outer.value if isinstance(outer, (ast.Assign, ast.AnnAssign)) else None
            if not isinstance(value, ast.Constant) or value.value is not None:
                found.setdefault(written(node), []).append((node, value))
        elif isinstance(node, ast.arg):
            found.setdefault(node.arg, []).append((node, None))
        elif isinstance(node, ast.Call) and isinstance(node.func, ast.Attribute) and node.func.attr == "open":
            found.setdefault(written(node.func.value), []).append((node, node))
    return found


def _opens_device(syntax: Syntax, value: ast.expr | None) -> bool:
    if not isinstance(value, ast.Call) or VIDEO_FILE.search(written(value)):
        return False
    return syntax.qualified(value) == _CAPTURE or getattr(value.func, "attr", "") == "open"


def _opens_again(syntax: Syntax, place: ast.AST, call: ast.Call) -> bool:
    """Whether an opening may run after the camera was lost: in the loop that reads, or in a function that more than the
    constructor mentions."""
    loops = {outer for outer, _ in syntax.within(call) if isinstance(outer, _LOOPS)}
    if any(outer in loops for outer, _ in syntax.within(place)):
        return True
    function = syntax.function(place)
    if function is None or function.name in _STARTS or (function is syntax.function(call) and loops):
        return False
    return function.name not in syntax.once(_starters)


def _starters(syntax: Syntax) -> set[str]:
    """The functions that only the constructor and ``main`` call, and that nothing hands over."""
    first: set[str] = set()
    others: set[str] = set()
    for node in syntax.file.nodes:
        if isinstance(node, (ast.Name, ast.Attribute)) and isinstance(node.ctx, ast.Load):
            function, (outer, field) = syntax.function(node), next(syntax.above(node))
            is_early = function is None or function.name in _STARTS
            is_call = isinstance(outer, ast.Call) and field == "func"
            (first if is_early and is_call else others).add(node.id if isinstance(node, ast.Name) else node.attr)
    return first - others


def _choice(syntax: Syntax, function: ast.AST, flag: str) -> ast.If | None:
    """The one condition that asks whether there is a picture."""
    uses = [each for each in walk(function) if isinstance(each, ast.Name) and each.id == flag]
    read = [each for each in uses if isinstance(each.ctx, ast.Load)]
    if len(read) != 1 or len(uses) != 2:
        return None
    outer = next((outer for outer, _ in syntax.within(read[0]) if isinstance(outer, ast.stmt)), None)
    return outer if isinstance(outer, ast.If) and not outer.orelse else None


def _without_picture(syntax: Syntax, choice: ast.If, flag: str) -> list[ast.stmt] | None:
    """The statements that run without a picture; None where the condition says something else."""
    test = choice.test.values[0] if isinstance(choice.test, ast.BoolOp) else choice.test
    if isinstance(test, ast.Name):
        return syntax.after(choice) if test.id == flag else None
    is_either = isinstance(choice.test, ast.BoolOp) and isinstance(choice.test.op, ast.And)
    is_negated = isinstance(test, ast.UnaryOp) and isinstance(test.op, ast.Not) and isinstance(test.operand, ast.Name)
    return choice.body if is_negated and not is_either and isinstance(choice.body[-1], _LEAVES[:2]) else None


def _goes_on(statement: ast.stmt) -> bool:
    """Whether a statement only leaves, waits or logs."""
    if isinstance(statement, ast.Return):
        return statement.value is None
    if isinstance(statement, _LEAVES):
        return True
    call = statement.value if isinstance(statement, ast.Expr) else None
    return isinstance(call, ast.Call) and called_name(call) in (*_LOGS, *_WAITS)


def _is_log(statement: ast.stmt) -> bool:
    return any(isinstance(each, ast.Call) and called_name(each) in _LOGS for each in own([statement]))
