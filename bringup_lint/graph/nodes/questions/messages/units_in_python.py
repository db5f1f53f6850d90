"""Percentages, degrees and readings of chips in Python nodes, where shares of 1, radians and SI units are meant."""

from __future__ import annotations

import ast
import re
from collections.abc import Iterator
from typing import TYPE_CHECKING

from bringup_lint.discover.kinds.launch import LAUNCH
from bringup_lint.facts.ros.message_units import CHIP_UNITS
from bringup_lint.facts.ros.message_units import FRACTIONS
from bringup_lint.facts.ros.message_units import RADIANS
from bringup_lint.facts.ros.message_units import ChipUnit
from bringup_lint.graph.nodes.questions.messages.wrong_unit import PERCENT
from bringup_lint.graph.nodes.questions.messages.wrong_unit import TELLS_APART
from bringup_lint.graph.nodes.questions.messages.wrong_unit import WrongUnit
from bringup_lint.graph.nodes.sources.message_types import MessageTypes
from bringup_lint.graph.nodes.sources.syntax import Syntax
from bringup_lint.graph.nodes.sources.syntax import own_calls
from bringup_lint.model.node_source import Parameter
from bringup_lint.model.node_source import reports_joints
from bringup_lint.model.python import FunctionNode
from bringup_lint.model.python import written
from bringup_lint.pattern import regex
from bringup_lint.source import Span

if TYPE_CHECKING:
    from bringup_lint.graph.nodes.nodes import Nodes

_DEGREES = frozenset({"math.degrees", "numpy.degrees", "numpy.rad2deg"})
_WRAPPERS = frozenset({"float", "round", "max", "min", "numpy.clip"})
_TWIST = "geometry_msgs/msg/Twist"
_JOINTS = "sensor_msgs/msg/JointState"
_PERCENT_FILE = regex(r"power_supply/[^\n'\"]*capacity\b")
_OTHER_ANGLES = regex(r"(?i)deg|euler|rpy|debug|plot|servo|gimbal|pan_?tilt")
"""Topics on which a Twist is no velocity, but three numbers."""


def in_python(nodes: Nodes, types: MessageTypes) -> Iterator[WrongUnit]:
    text = types.file.source.text
    if not any(kind.rpartition("/")[2] in text for kind in (*FRACTIONS, *RADIANS, *CHIP_UNITS)):
        return
    for node in types.file.nodes:
        if isinstance(node, ast.Compare):
            yield from _compared(nodes, types, node)
        elif isinstance(node, ast.Assign) and len(node.targets) == 1 and isinstance(node.targets[0], ast.Attribute):
            yield from _assigned(types, node.targets[0], node.value)
        elif isinstance(node, ast.Call):
            yield from _made(types, node)


def _made(types: MessageTypes, call: ast.Call) -> Iterator[WrongUnit]:
    """What is given to the constructor of a message."""
    kind = types.made(call)
    if kind is None:
        return
    for each in call.keywords:
        yield from _given(types, kind, str(each.arg), each.value)


def _compared(nodes: Nodes, types: MessageTypes, node: ast.Compare) -> Iterator[WrongUnit]:
    """Where a share is compared with a number above 1."""
    sides = [node.left, *node.comparators]
    for one, other in zip([*sides, *sides[1:]], [*sides[1:], *sides], strict=False):
        kind = types.of(one.value) if isinstance(one, ast.Attribute) else None
        if kind is None or FRACTIONS.get(kind) != one.attr:  # type: ignore[attr-defined]
            continue
        limit, parameter = _limit(types, other)
        if _is_percentage(limit) and not _is_set(nodes, parameter) and not TELLS_APART.search(_text(types)):
            declared = parameter.span if parameter is not None else None
            yield WrongUnit(types.file.span_of(node), kind, FRACTIONS[kind], True, f"{limit:g}", declared)


def _is_percentage(value: object) -> bool:
    return isinstance(value, (int, float)) and not isinstance(value, bool) and PERCENT <= value <= 100


def _limit(types: MessageTypes, node: ast.expr) -> tuple[object, Parameter | None]:
    """The number that a value is compared with, and the parameter of which it is the default."""
    known = types.file.constant(node, types.syntax.function(node))
    if known is not None or not isinstance(node, ast.Attribute):
        return known, None
    value = types.kept(node)
    while isinstance(value, ast.Attribute):
        value = value.value
    calls = own_calls([value]) if value is not None else iter(())
    call = next((each for each in calls if _name(each.func).endswith("_parameter")), None)
    name = types.file.constant(call.args[0], types.syntax.function(call)) if call is not None and call.args else None
    declared = (each.parameter(str(name)) for each in types.file.classes)
    found = [each for each in declared if each is not None]
    return (found[0].default, found[0]) if len(found) == 1 else (None, None)


def _is_set(nodes: Nodes, parameter: Parameter | None) -> bool:
    """Whether a file of the tree may set a parameter to something else than a percentage."""
    if parameter is None:
        return False
    kinds = ("params", *LAUNCH)
    named = re.compile(rf"\b{re.escape(parameter.name)}\b[\"']?(?:[ \t]*:[ \t]*(?P<number>\d+(?:\.\d*)?)\b)?")
    found = [each for source in nodes.files.of_kind(*kinds) for each in named.finditer(source.text)]
    return not all(each["number"] and float(each["number"]) >= PERCENT for each in found)


def _assigned(types: MessageTypes, target: ast.Attribute, value: ast.expr) -> Iterator[WrongUnit]:
    """What goes into a field: ``msg.percentage``, ``msg.angular_velocity.x``."""
    path = [target.attr]
    owner = target.value
    for _ in range(2):
        kind = types.of(owner)
        if kind is not None:
            found = list(_given(types, kind, ".".join(path), value, types.file.span_of(target)))
            if found and (types.syntax.function(target), written(target)) not in types.syntax.once(_converted):
                yield from found
        if not isinstance(owner, ast.Attribute):
            return
        path.insert(0, owner.attr)
        owner = owner.value


def _converted(syntax: Syntax) -> frozenset[tuple[FunctionNode | None, str]]:
    """The fields that functions make from what is in them, each as it is written: ``msg.fluid_pressure *= 100``."""
    found = set()
    for node in syntax.file.nodes:
        if isinstance(node, ast.AugAssign) and isinstance(node.target, ast.Attribute):
            found.add((syntax.function(node), written(node.target)))
        elif isinstance(node, ast.Assign) and isinstance(node.targets[0], ast.Attribute):
            target = written(node.targets[0])
            if target and target in {written(each) for each in ast.walk(node.value) if isinstance(each, ast.Attribute)}:
                found.add((syntax.function(node), target))
    return frozenset(found)


def _given(
    types: MessageTypes, kind: str, field: str, value: ast.expr, place: Span | None = None
) -> Iterator[WrongUnit]:
    place = place or types.file.span_of(value)
    if FRACTIONS.get(kind) == field:
        percent = _percent(types, value)
        if percent is not None:
            yield WrongUnit(place, kind, field, False, percent)
    elif field in RADIANS.get(kind, ()) and _is_judged(types, kind) and _in_degrees(types, value):
        yield WrongUnit(place, kind, field, False, "degrees")
    chip = CHIP_UNITS.get(kind)
    if chip is not None and field in chip.fields and _is_of_chip(types, value, chip):
        yield WrongUnit(place, kind, field, False, chip.of_chip, chip=chip)


def _is_of_chip(types: MessageTypes, value: ast.expr, chip: ChipUnit) -> bool:
    """Whether a value is a reading of a chip as its library gives it: ``self.bmp.pressure``."""
    inner = _unwrapped(types, value)
    if isinstance(inner, ast.Subscript):
        inner = _unwrapped(types, inner.value)
    if not isinstance(inner, ast.Attribute) or inner.attr != chip.property:
        return False
    made = types.kept(inner.value) if isinstance(inner.value, ast.Attribute) else _unwrapped(types, inner.value)
    name = types.file.qualified(made.func) if isinstance(made, ast.Call) else None
    return (name or "").partition(".")[0] in chip.libraries


def _is_judged(types: MessageTypes, kind: str) -> bool:
    """Whether joint states are a reading, and a Twist a velocity: on other topics, they may be commands in a servo's
    own unit, or numbers to look at."""
    endpoints = [each for cls in types.file.classes for each in cls.all_endpoints]
    if kind == _TWIST:
        sent = [each for each in (*endpoints, *types.file.strays) if each.role == "publisher" and each.type == kind]
        return not any(_OTHER_ANGLES.search(str(each.name or "deg")) for each in sent)
    return kind != _JOINTS or reports_joints([*endpoints, *types.file.strays])


def _percent(types: MessageTypes, value: ast.expr) -> str | None:
    """The number of a percentage; an empty one when only its unit is known; None when it is none."""
    number = types.file.constant(value, types.syntax.function(value))
    if number is not None:
        return f"{number:g}" if _is_percentage(number) else None
    inner = _unwrapped(types, value)
    if isinstance(inner, ast.BinOp) and isinstance(inner.op, ast.Mult):
        sides = (types.file.constant(each, types.syntax.function(value)) for each in (inner.left, inner.right))
        return "" if any(each == 100 for each in sides) else None
    if isinstance(inner, ast.Call) and _reads_capacity(types, inner):
        return ""
    is_psutil = isinstance(inner, ast.Attribute) and inner.attr == "percent" and "sensors_battery" in _text(types)
    return "" if is_psutil else None


def _unwrapped(types: MessageTypes, value: ast.expr) -> ast.expr:
    """What is inside ``float(...)``, ``round(...)``, and the first argument but constants of ``max(0.0, ...)``; the
    value that alone is bound to a local name."""
    for _ in range(6):
        if isinstance(value, ast.Name):
            bound = types.bound(value)
            if bound is None:
                return value
            value = bound
        elif isinstance(value, ast.Call) and (types.file.qualified(value.func) or _name(value.func)) in _WRAPPERS:
            given = [each for each in value.args if not isinstance(each, ast.Constant)]
            if not given:
                return value
            value = given[0]
        else:
            return value
    return value


def _name(node: ast.expr) -> str:
    """The last word of what is called."""
    return node.id if isinstance(node, ast.Name) else getattr(node, "attr", "")


def _reads_capacity(types: MessageTypes, call: ast.Call) -> bool:
    """Whether a value is the text of ``/sys/class/power_supply/*/capacity``, which is a percentage (kernel,
    Documentation/ABI/testing/sysfs-class-power)."""
    names = [each.func.attr for each in own_calls([call]) if isinstance(each.func, ast.Attribute)]
    is_read = any(name in ("read", "read_text", "readline", "strip") for name in names)
    return is_read and types.file.source.once(_reads_capacity, lambda: _capacities(types)) == 1


def _capacities(types: MessageTypes) -> int:
    """How many such files a source names."""
    return len(_PERCENT_FILE.findall(_text(types)))


def _text(types: MessageTypes) -> str:
    return types.file.source.text


def _in_degrees(types: MessageTypes, value: ast.expr) -> bool:
    """Whether a value, or every element of a list, is made degrees at last."""
    inner = _unwrapped(types, value)
    if isinstance(inner, (ast.ListComp, ast.GeneratorExp)):
        return _in_degrees(types, inner.elt)
    if isinstance(inner, (ast.List, ast.Tuple)):
        return bool(inner.elts) and all(_in_degrees(types, each) for each in inner.elts)
    if isinstance(inner, ast.UnaryOp):
        return _in_degrees(types, inner.operand)
    return isinstance(inner, ast.Call) and types.file.qualified(inner.func) in _DEGREES
