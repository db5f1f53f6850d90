"""Elements of arrays that the callbacks of a C++ file take from messages without a look at the size."""

from __future__ import annotations

import re
from collections import Counter
from collections.abc import Iterator
from itertools import islice
from typing import TYPE_CHECKING

from bringup_lint.facts.ros.short_arrays import COMMON
from bringup_lint.facts.ros.short_arrays import EMPTY
from bringup_lint.facts.ros.short_arrays import JOYSTICK
from bringup_lint.facts.ros.short_arrays import SEEN
from bringup_lint.facts.ros.short_arrays import SEEN_WORDS
from bringup_lint.model.cpp_source import UncheckedElement
from bringup_lint.model.cpp_source import UncheckedElements
from bringup_lint.model.cpp_text import plain_of
from bringup_lint.model.node_source import Callback
from bringup_lint.parsers.cpp_node.syntax import Code
from bringup_lint.parsers.cpp_node.waits import Bodies
from bringup_lint.pattern import regex

if TYPE_CHECKING:
    from tree_sitter import Node

MOST = 200
"""Elements of one file that are looked at."""
_FIELDS = "|".join(sorted({SEEN_WORDS, *COMMON, *(each for fields in EMPTY.values() for each in fields)}))
TAKES = regex(
    rf"(?:->|\.)\s{{0,4}}(?:{_FIELDS})\s{{0,4}}(?:\[|\.\s{{0,4}}(?:front|back)\b)",
    hints=_FIELDS.replace("|", " "),
)
_MESSAGE = regex(
    r"\b(?P<package>\w{1,60})::msg::(?P<type>[A-Z]\w{0,80})(?:::\w{0,40}Ptr)?\s{0,4}>?\s{0,4}(?:const\s{0,4})?&{0,2}\s{0,4}"
    r"(?P<name>[A-Za-z_]\w{0,80})\Z"
)
_INDEX = regex(r"\[\s{0,4}(?P<index>[A-Za-z0-9_.:>-]{1,80})\s{0,4}\]|\.\s{0,4}(?P<end>front|back)(?P<call>\s{0,4}\()")
_VALUE = regex(
    r"(?<![\w.])(?P<name>[A-Za-z_][\w.]{0,80})\s{0,4}(?:=|\{)\s{0,4}(?:[\w>-]{0,40}declare_parameter\s{0,4}(?:<[\w:]{1,20}>)?\("
    r"\s{0,8}\"[\w./]{1,80}\",\s{0,8})?(?P<number>\d{1,3})\s{0,4}\)?\s{0,4}[;,}]"
)
"""What gives a name a number; a parameter its default."""
_SET = regex(
    r"(?<![\w.])(?P<name>[A-Za-z_][\w.]{0,80})\s{0,4}(?:[-+*/%&|^]?=(?!=)|\{|\+\+|--)"
    r"|[\w>]\s{0,4}[\s&*]\s{0,4}(?P<taken>[A-Za-z_]\w{0,80})\s{0,4}[,):](?!:)"
)
"""What gives a name any value; a function takes it."""
_SIZE = regex(r"\s{0,4}\.\s{0,4}(?:size|empty)\b")
_CHOOSES = regex(r"\b(?:if|try)\b|\?|&&")
_ASSIGNED = regex(r"\s{0,4}=(?!=)")
_ASKING = {
    "if_statement": "condition",
    "while_statement": "condition",
    "for_statement": "condition",
    "for_range_loop": "right",
    "conditional_expression": "condition",
}
_LEAVES = regex(
    r"\b(?:return|throw|continue|break|goto|\w{0,20}exit|abort)\b|(?<![\w.>\]])[A-Za-z_]\w{0,60}\s{0,4}=(?!=)"
)
"""By what a branch decides about what comes after it."""


def unchecked_elements(code: Code, callbacks: list[Callback]) -> Iterator[UncheckedElements]:
    """One for each callback that takes elements unseen which need not be there."""
    if not TAKES.search(code.source.text):
        return
    bodies = Bodies(code)
    indexes = _Indexes(plain_of(code.source))
    seen: set[int] = set()
    for body in _callbacks(code, bodies, callbacks):
        message = _message(code, body) if body.id not in seen else None
        seen.add(body.id)
        if message is not None:
            yield from _in(code, body, *message, indexes)


def _callbacks(code: Code, bodies: Bodies, callbacks: list[Callback]) -> Iterator[Node]:
    """What subscriptions run with a message."""
    for callback in callbacks:
        body = bodies.of(callback) if callback.role == "subscription" else None
        if body is not None and callback.name is not None:
            yield body
    subscribed = [call for call in code.calls if call.name == "create_subscription"]
    given = {each.id for call in subscribed for each in call.arguments}
    named_as = {code.text(each) for call in subscribed for each in call.arguments if each.type == "identifier"}
    for each in code.written.get("lambda", ()):
        if each.id not in given and _kept_as(code, each) not in named_as:
            continue
        yield each
        calls = [call for call in bodies.own(each) if call.arguments]
        if len(calls) != 1 or _CHOOSES.search(code.text(each)):
            continue
        named = bodies.functions.get(calls[0].name, [])
        if len(named) == 1 and calls[0].qualified in (calls[0].name, f"this->{calls[0].name}"):
            yield named[0]


def _kept_as(code: Code, node: Node) -> str | None:
    """The variable that a lambda is kept in."""
    outer = next(iter(code.above(node)), None)
    declarator = outer.child_by_field_name("declarator") if outer is not None else None
    return code.text(declarator) if declarator is not None else None


def _message(code: Code, body: Node) -> tuple[str, str] | None:
    """The type and the name of the only parameter of a callback, when it is a message."""
    declarator = body.child_by_field_name("declarator")
    while declarator is not None and declarator.child_by_field_name("parameters") is None:
        declarator = declarator.child_by_field_name("declarator")
    given = declarator.child_by_field_name("parameters") if declarator is not None else None
    every = [each for each in given.named_children if each.type != "comment"] if given is not None else []
    found = _MESSAGE.search(" ".join(code.text(every[0]).split())) if len(every) == 1 else None
    return (f"{found['package']}/msg/{found['type']}", found["name"]) if found is not None else None


def _in(code: Code, body: Node, type_name: str, message: str, indexes: _Indexes) -> Iterator[UncheckedElements]:
    plain, span = plain_of(code.source), code.span(body)
    named = re.compile(rf"(?<![\w.>]){re.escape(message)}\s{{0,4}}(?:->|\.)\s{{0,4}}(?P<field>[a-z]\w{{0,60}})")
    handed = re.compile(rf"[(,]\s{{0,4}}\*?{re.escape(message)}\s{{0,4}}[,)]").search(plain, span.start, span.end)
    end = handed.start() if handed is not None else span.end
    taken: list[UncheckedElement] = []
    asked: list[int] = []
    for each in islice(named.finditer(plain, span.start, span.end), MOST):
        field = each["field"]
        is_short = _is_short(type_name, field)
        index = _INDEX.match(plain, each.end()) if is_short else None
        if index is not None and not _ASSIGNED.match(plain, index.end()) and each.start() < end:
            number = 0 if index["end"] else indexes.number(index["index"], field in COMMON)
            place = code.source.span(each.start(), index.end() - len(index["call"] or ""))
            taken.append(UncheckedElement(place, field, number))
        elif index is None and (is_short or _SIZE.match(plain, each.end())):
            asked.append(each.start())
    guards = [_Guard(code, body, each) for each in asked]
    bare = [each for each in taken if not any(guard.holds(each.place.start) for guard in guards)]
    fields = dict.fromkeys(each.field for each in bare)
    worst = [max((each for each in bare if each.field == field), key=_rank) for field in fields]
    told = [each for each in worst if each.number >= COMMON.get(each.field, 0)]
    if told:
        first = next(each for each in bare if each.field in {each.field for each in told})
        yield UncheckedElements(first.place, type_name, told)


def _rank(element: UncheckedElement) -> tuple[int, int]:
    return element.number, -element.place.start


def _is_short(type_name: str, field: str) -> bool:
    if type_name == JOYSTICK:
        return field in COMMON
    return field in EMPTY.get(type_name, ()) or SEEN.match(field) is not None


class _Indexes:
    """The names by which a file takes elements."""

    def __init__(self, plain: str) -> None:
        self._numbers: dict[str, list[int]] = {}
        for each in _VALUE.finditer(plain):
            self._numbers.setdefault(each["name"], []).append(int(each["number"]))
        self._set = Counter(each["name"] or each["taken"] for each in _SET.finditer(plain))

    def number(self, written: str, is_named: bool) -> int:
        """What an index surely is, or is by default; -1 where that is not known, and for the variable of a loop."""
        if written.isdecimal():
            return int(written)
        name = _name(written)
        known = self._numbers.get(name, []) if is_named else []
        return known[0] if len(set(known)) == 1 and self._set[name] == len(known) else -1


def _name(written: str) -> str:
    return written.rpartition("::")[2].removeprefix("this->")


class _Guard:
    """A place that looks at the arrays of a message."""

    def __init__(self, code: Code, body: Node, at: int) -> None:
        self._code = code
        node = code.at(at)
        self._branch = _branch(code, body, node) if node is not None else None

    def holds(self, at: int) -> bool:
        """Whether a place may depend on the answer."""
        if self._branch is None:
            return True
        span = self._code.span(self._branch)
        return span.start <= at < span.end or _LEAVES.search(span.text) is not None


def _branch(code: Code, body: Node, node: Node) -> Node | None:
    """The statement whose condition a place is in; None when it is in another place."""
    current = node
    for outer in code.above(node):
        condition = outer.child_by_field_name(_ASKING[outer.type]) if outer.type in _ASKING else None
        if condition is not None and condition.start_byte <= node.start_byte < condition.end_byte:
            return outer
        if outer.id == body.id or current.type in ("expression_statement", "declaration"):
            return None
        current = outer
    return None
