"""Readings that guard a motion however old they are."""

from __future__ import annotations

import ast
import re
from collections.abc import Iterator
from typing import TYPE_CHECKING

from bringup_lint.graph.nodes.questions.commands.repeating import ignores_time
from bringup_lint.graph.nodes.questions.commands.repeating import is_motion
from bringup_lint.graph.nodes.sources.age import looks_at_age
from bringup_lint.graph.nodes.sources.callback_code import reached
from bringup_lint.graph.nodes.sources.kept_commands import Loop
from bringup_lint.graph.nodes.sources.kept_commands import held_over
from bringup_lint.graph.nodes.sources.kept_commands import loops
from bringup_lint.graph.nodes.sources.syntax import Syntax
from bringup_lint.graph.nodes.sources.syntax import body_of
from bringup_lint.graph.nodes.sources.with_header import with_header
from bringup_lint.model.cpp_text import COMMENT
from bringup_lint.model.node_source import Endpoint
from bringup_lint.model.node_source import NodeClass
from bringup_lint.model.python import called_name
from bringup_lint.model.python import is_own
from bringup_lint.model.python import written
from bringup_lint.named_tuple import NamedTuple
from bringup_lint.pattern import regex
from bringup_lint.source import Source
from bringup_lint.source import Span

if TYPE_CHECKING:
    from bringup_lint.graph.nodes.nodes import Nodes
    from bringup_lint.model.cpp_source import CppNode
    from bringup_lint.model.node_source import Callback
    from bringup_lint.model.node_source import NodeSource

_READINGS = frozenset(
    {"sensor_msgs/msg/LaserScan", "sensor_msgs/msg/Range", "sensor_msgs/msg/PointCloud2", "nav_msgs/msg/Odometry"}
)
"""What a sensor sends again and again, so that its absence is a failure."""

_SENSOR = regex(r"(?:Sensors?|Reading|Measurement)\Z")
_COMMAND = regex(r"(?:Cmd|Command)\Z")
_CLOCKS = frozenset(("now", "time", "time_ns", "monotonic", "monotonic_ns", "perf_counter", "perf_counter_ns"))
_SET = regex(r"[;{})]\s{0,80}(?:this->)?(?P<name>[A-Za-z]\w{0,80})\s{0,3}=\s{0,3}(?P<value>0|true|false)(?=;)")
_COUNTED = regex(
    r"(?:\+\+|--)(?:this->)?(?P<before>[A-Za-z]\w{0,80})|\b(?P<after>[A-Za-z]\w{0,80})(?:\+\+|--|\s{0,3}[+-]=)"
)
_SPEED = regex(r"(?i)(?:\A|_)(?:speeds?|velocity|velocities|throttle|thrust|rpms?)(?:\Z|_)")
"""The names of fields of which the motion follows."""
_SPEED_SET = regex(
    r"(?<!this)(?:->|\.)(?:\w{1,40}_)?(?:speeds?|velocity|velocities|throttle|thrust|rpms?)(?:_\w{1,40})?\s{0,4}=(?!=)",
    hints="speed veloci throttle thrust rpm",
)
_VELOCITIES = ("Twist", "TwistStamped")


class StaleReading(NamedTuple):
    source: Source
    subscription: Endpoint
    kept: str
    """The attribute that holds the reading: ``self.nearest``."""
    used: Span
    """Where what moves the robot uses it."""
    mover: str
    """The callback or thread that moves it: ``on_cmd()``."""
    until_first: str
    """What it holds before the first message, where that lets the robot move: ``inf``, ``False``; else empty."""
    drives: bool
    """Velocities are sent by it, or speeds of motors; else commands of another kind, such as the angle of a flap."""


def stale_readings(nodes: Nodes) -> Iterator[StaleReading]:
    """The readings that one callback keeps, and that another one which publishes velocities uses, in sources that look
    at no time."""
    for file, node in nodes.node_classes:
        readings = [each for each in node.endpoints if _is_reading(each)]
        if readings and any(_is_motion(each) for each in node.all_endpoints) and ignores_time(nodes, file):
            yield from _in_class(nodes, file, node, readings)
    for source in nodes.cpp:
        yield from _in_cpp(nodes, source)


def _in_class(nodes: Nodes, file: NodeSource, node: NodeClass, readings: list[Endpoint]) -> Iterator[StaleReading]:
    syntax = nodes.syntax(file)
    is_velocity = any(map(is_motion, node.all_endpoints))
    for mover in [*loops(syntax, node), *_commanded(syntax, node)]:
        if not any(_moves(each, node) for each in mover.code):
            continue
        drives = is_velocity or any(map(_is_speed, mover.code))
        for reading in readings:
            if _is_timed(syntax, node, reading, mover):
                continue
            for name in sorted(held_over(syntax, node, reading.callback, mover)):
                used = next(_reads(mover.code, name), None)
                if used is not None:
                    place = file.span_of(used)
                    first = _before(file, node, name)
                    yield StaleReading(file.source, reading, f"self.{name}", place, f"{mover.name}()", first, drives)
                    break


def _is_speed(node: ast.AST) -> bool:
    """Whether a speed of a message is set, as a field or where it is made."""
    if isinstance(node, ast.keyword):
        return node.arg is not None and _SPEED.search(node.arg) is not None
    if not isinstance(node, ast.Attribute) or is_own(node):
        return False
    return isinstance(node.ctx, ast.Store) and _SPEED.search(node.attr) is not None


def _is_timed(syntax: Syntax, node: NodeClass, reading: Endpoint, mover: Loop) -> bool:
    """Whether a callback asks for the time, or counts, so that the mover can see how old the reading is."""
    method = node.methods.get(reading.callback or "")
    code = reached(syntax, body_of(method.node), node) if method is not None else []
    if any(isinstance(each, ast.Call) and called_name(each) in _CLOCKS for each in code):
        return True
    counted = {name for each in code for name in _counted(each)}
    return any(isinstance(each, ast.Attribute) and each.attr in counted for each in mover.code)


def _counted(node: ast.AST) -> Iterator[str]:
    """``x`` of ``self.x += 1`` and ``self.x = self.turns``, which come from no message."""
    if isinstance(node, ast.AugAssign):
        targets: list[ast.expr] = [node.target] if isinstance(node.value, ast.Constant) else []
    elif isinstance(node, ast.Assign):
        targets = node.targets if is_own(node.value) else []
    else:
        return
    yield from (each.attr for each in targets if is_own(each))


def _is_motion(endpoint: Endpoint) -> bool:
    return is_motion(endpoint) or (endpoint.role == "publisher" and bool(_COMMAND.search(endpoint.type or "")))


def _is_reading(endpoint: Endpoint) -> bool:
    if endpoint.role != "subscription" or endpoint.type is None:
        return False
    return endpoint.type in _READINGS or bool(_SENSOR.search(endpoint.type))


def _in_cpp(nodes: Nodes, source: CppNode) -> Iterator[StaleReading]:
    readings = [each for each in source.endpoints if _is_reading(each)]
    if not readings or not any(_is_motion(each) for each in source.endpoints):
        return
    text = with_header(nodes, source.source)
    if looks_at_age(text):
        return
    signs = _signs(text)
    drives = any(map(is_motion, source.endpoints)) or bool(_SPEED_SET.search(COMMENT.sub(" ", text)))
    for reading in readings:
        if any(_is_within(at, reading.span) and names & _CLOCKS for at, names in source.called.items()):
            continue
        names = next((names for at, names in source.kept.items() if _is_within(at, reading.span)), frozenset())
        for mover in source.callbacks:
            words = source.sent.get(mover.span.start) or _passed_on(source, mover)
            if signs & words:
                continue
            for name in sorted(names & words)[:1]:
                label = f"{mover.name}()" if mover.name is not None else f"The callback of a {mover.role}"
                before = _cpp_before(text, name)
                yield StaleReading(source.source, reading, name, mover.span, label, before, drives)


def _signs(text: str) -> frozenset[str]:
    """Members that say whether a reading is new: counters that start again, flags that are set and reset."""
    plain = COMMENT.sub(" ", text)
    values: dict[str, set[str]] = {}
    for each in _SET.finditer(plain):
        values.setdefault(each["name"], set()).add(each["value"])
    counted = {each["before"] or each["after"] for each in _COUNTED.finditer(plain)}
    return frozenset(name for name, given in values.items() if len(given) > 1 or (given == {"0"} and name in counted))


def _passed_on(source: CppNode, mover: Callback) -> frozenset[str]:
    """The words of a callback that takes velocities and sends something."""
    taken = [
        each for each in source.endpoints if each.role == "subscription" and _is_within(mover.span.start, each.span)
    ]
    is_velocity = any((each.type or "").rpartition("/")[2] in _VELOCITIES for each in taken)
    return source.passed_on.get(mover.span.start, frozenset()) if is_velocity else frozenset()


def _is_within(at: int, span: Span) -> bool:
    return span.start <= at < span.end


def _cpp_before(text: str, name: str) -> str:
    """What a member is initialised with when that is no sign of a missing reading."""
    given = re.compile(rf"\b{re.escape(name)}\s{{0,4}}[={{(]\s{{0,4}}(?P<value>[^;,}}=]{{1,60}})")
    values = [each["value"].strip() for each in given.finditer(text)]
    if any("infinity" in each.lower() for each in values):
        return "inf"
    return next((each for each in values if each in ("false", "true")), "")


def _commanded(syntax: Syntax, node: NodeClass) -> Iterator[Loop]:
    """The callbacks of the velocities that a node passes on."""
    for each in node.endpoints:
        method = node.methods.get(each.callback or "")
        kind = (each.type or "").rpartition("/")[2]
        if each.role == "subscription" and method is not None and kind in _VELOCITIES:
            yield Loop(str(method.name), each.span, reached(syntax, body_of(method.node), node))


def _moves(call: ast.AST, node: NodeClass) -> bool:
    if not isinstance(call, ast.Call) or not isinstance(call.func, ast.Attribute) or call.func.attr != "publish":
        return False
    kept = written(call.func.value)
    return any(each.attribute == kept and _is_motion(each) for each in node.all_endpoints)


def _reads(code: list[ast.AST], name: str) -> Iterator[ast.Attribute]:
    for each in code:
        if isinstance(each, ast.Attribute) and each.attr == name and isinstance(each.ctx, ast.Load):
            yield each


def _before(file: NodeSource, node: NodeClass, name: str) -> str:
    """What the constructor sets an attribute to when that is no sign of a missing reading."""
    init = node.methods.get("__init__")
    if init is None:
        return ""
    for each in body_of(init.node):
        targets = each.targets if isinstance(each, ast.Assign) else [getattr(each, "target", None)]
        if any(isinstance(target, ast.Attribute) and target.attr == name for target in targets):
            text = written(each.value) if isinstance(each, (ast.Assign, ast.AnnAssign)) and each.value else ""
            return "inf" if "inf" in text else text if text in ("False", "True") else ""
    return ""
