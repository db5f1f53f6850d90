"""Values of messages in another unit than their definitions give."""

from __future__ import annotations

import ast
import re
from collections.abc import Iterator
from typing import TYPE_CHECKING

from bringup_lint.facts.ros.message_units import FRACTIONS
from bringup_lint.facts.ros.message_units import RADIANS
from bringup_lint.graph.nodes.questions.message_types import MessageTypes
from bringup_lint.graph.nodes.sources.syntax import own_calls
from bringup_lint.model.cpp_source import COMMENT
from bringup_lint.model.node_source import reports_joints
from bringup_lint.named_tuple import NamedTuple
from bringup_lint.pattern import regex
from bringup_lint.source import Span

if TYPE_CHECKING:
    from bringup_lint.graph.nodes.nodes import Nodes

PERCENT = 5
"""The smallest number that is surely a percentage; 1.5 and the like ask whether the other side is right."""
_BATTERIES = frozenset({"BatteryState", "msg::BatteryState", "sensor_msgs::msg::BatteryState"})
_UNKNOWN = frozenset({"?"})
_DEGREES = frozenset({"math.degrees", "numpy.degrees", "numpy.rad2deg"})
_WRAPPERS = frozenset({"float", "round", "max", "min", "numpy.clip"})
_TWIST = "geometry_msgs/msg/Twist"
_JOINTS = "sensor_msgs/msg/JointState"
_PERCENT_FILE = regex(r"power_supply/[^\n'\"]*capacity\b")
_CPP_FIELD = regex(
    r"\b(?P<message>\w+)(?:->|\.)percentage\s{0,4}(?:[<>]=?|(?P<set>=)(?!=))\s{0,4}"
    r"(?P<number>\d{1,3}(?:\.\d*)?)f?\s{0,4}(?=[;)&|])"
)
_TELLS_APART = regex(
    r"\.(?:percentage|relative_humidity)\s{0,4}[<>]=?\s{0,4}[12](?:\.\d{1,3})?(?![\d.])"
    r"|->percentage\s{0,4}[<>]=?\s{0,4}[12](?:\.\d{1,3})?(?![\d.])"
)
"""A comparison that finds out whether a driver publishes shares or percentages."""
_OTHER_ANGLES = regex(r"(?i)deg|euler|rpy|debug|plot|servo|gimbal|pan_?tilt")
"""Topics on which a Twist is no velocity, but three numbers."""
_CPP_TIMES = regex(r"\b(?P<message>\w+)(?:->|\.)percentage\s{0,4}=[^;=\n]{1,200}\*\s{0,4}100(?:\.0*)?f?\s{0,4};")
"""A value that is made a percentage at last."""
_CPP_DECLARED = regex(
    r"(?<![\w:])(?P<type>\w[\w:]{0,120}?)(?:::\w{0,20}Ptr)?[ \t>&*]{1,4}(?=(?P<name>\w+)\s{0,4}[;,)({=])"
)


class WrongUnit(NamedTuple):
    place: Span
    type: str
    field: str
    is_read: bool
    """A limit for a value that comes in; else the value that goes out."""
    got: str
    """``20`` for a percentage, empty where it is not known; ``degrees``."""


def wrong_units(nodes: Nodes) -> Iterator[WrongUnit]:
    """Percentages where a share of 1 is meant, and degrees where radians are.

    A limit in percent is right where the tree itself publishes percentages: only what goes out is told then."""
    found = [each for types in nodes.message_types for each in _in_python(nodes, types)]
    found += [each for source in nodes.cpp for each in _in_cpp(source.source.text, source.source.whole)]
    sent = {each.type for each in found if not each.is_read}
    yield from (each for each in found if not each.is_read or each.type not in sent)


def _in_python(nodes: Nodes, types: MessageTypes) -> Iterator[WrongUnit]:
    text = types.file.source.text
    if not any(kind.rpartition("/")[2] in text for kind in (*FRACTIONS, *RADIANS)):
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
        if _is_percentage(limit) and not _is_set(nodes, parameter) and not _TELLS_APART.search(_text(types)):
            yield WrongUnit(types.file.span_of(node), kind, FRACTIONS[kind], True, f"{limit:g}")


def _is_percentage(value: object) -> bool:
    return isinstance(value, (int, float)) and not isinstance(value, bool) and PERCENT <= value <= 100


def _limit(types: MessageTypes, node: ast.expr) -> tuple[object, str]:
    """The number that a value is compared with, and the parameter of which it is the default."""
    known = types.file.constant(node, types.syntax.function(node))
    if known is not None or not isinstance(node, ast.Attribute):
        return known, ""
    value = types.kept(node)
    while isinstance(value, ast.Attribute):
        value = value.value
    calls = own_calls([value]) if value is not None else iter(())
    call = next((each for each in calls if _name(each.func).endswith("_parameter")), None)
    name = types.file.constant(call.args[0], types.syntax.function(call)) if call is not None and call.args else None
    found = [each.all_parameters[str(name)] for each in types.file.classes if name in each.all_parameters]
    return (found[0].default, str(name)) if len(found) == 1 else (None, "")


def _is_set(nodes: Nodes, parameter: str) -> bool:
    """Whether a file of the tree may set a parameter to something else than a percentage."""
    if not parameter:
        return False
    kinds = ("params", "launch-python", "launch-xml", "launch-yaml")
    named = re.compile(rf"\b{re.escape(parameter)}\b[\"']?(?:[ \t]*:[ \t]*(?P<number>\d+(?:\.\d*)?)\b)?")
    found = [each for source in nodes.files.of_kind(*kinds) for each in named.finditer(source.text)]
    return not all(each["number"] and float(each["number"]) >= PERCENT for each in found)


def _assigned(types: MessageTypes, target: ast.Attribute, value: ast.expr) -> Iterator[WrongUnit]:
    """What goes into a field: ``msg.percentage``, ``msg.angular_velocity.x``."""
    path = [target.attr]
    owner = target.value
    for _ in range(2):
        kind = types.of(owner)
        if kind is not None:
            yield from _given(types, kind, ".".join(path), value, types.file.span_of(target))
        if not isinstance(owner, ast.Attribute):
            return
        path.insert(0, owner.attr)
        owner = owner.value


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


def _in_cpp(text: str, whole: Span) -> Iterator[WrongUnit]:
    if "sensor_msgs/msg/battery_state" not in text or "percentage" not in text:
        return
    kind = "sensor_msgs/msg/BatteryState"
    plain = COMMENT.sub(lambda found: " " * len(found[0]), text)
    types = _declared(plain)
    for found in _CPP_FIELD.finditer(plain):
        if PERCENT <= float(found["number"]) <= 100 and types.get(found["message"], _UNKNOWN) <= _BATTERIES:
            if found["set"] is None and _TELLS_APART.search(plain):
                continue
            place = Span(whole.source, found.start(), found.end())
            yield WrongUnit(place, kind, "percentage", found["set"] is None, found["number"])
    for found in _CPP_TIMES.finditer(plain):
        if types.get(found["message"], _UNKNOWN) <= _BATTERIES:
            yield WrongUnit(Span(whole.source, found.start(), found.end() - 1), kind, "percentage", False, "")


def _declared(text: str) -> dict[str, set[str]]:
    """Variable or member -> the types that it is declared with anywhere in a source."""
    found: dict[str, set[str]] = {}
    for each in _CPP_DECLARED.finditer(text):
        if each["type"] not in ("return", "else"):
            found.setdefault(each["name"], set()).add(each["type"])
    return found
