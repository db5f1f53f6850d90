"""The fixed joints that xacro surely makes of robot descriptions, with the calls of their macros."""

from __future__ import annotations

import math
from collections.abc import Iterator
from typing import TYPE_CHECKING

from bringup_lint.dataclass import dataclass
from bringup_lint.dataclass import field
from bringup_lint.graph.launch.python_expression import NotEvaluated
from bringup_lint.graph.launch.python_expression import evaluate
from bringup_lint.named_tuple import NamedTuple
from bringup_lint.pattern import regex

if TYPE_CHECKING:
    from bringup_lint.model.xml import Element
    from bringup_lint.source import Span

_SUBSTITUTION = regex(r"\$\{(?P<expression>[^{}]*)\}|\$\(arg[ \t]+(?P<argument>\w+)[ \t]*\)")
_WORD = regex(r"[A-Za-z_][\w.]*")
_PARAMETER = regex(
    r"(?P<block>\*{1,2})?(?P<name>[A-Za-z_]\w*)(?:[ \t]*:=[ \t]*(?P<default>'[^']*'|\"[^\"]*\"|[^\s'\"]+))?"
)
_DEEP = 5
"""Macros within macros that are followed."""
_CALLS = 2_000
"""Calls of macros of one description."""
_STEPS = 50
"""Properties of properties that are followed."""
_LONG = 1_000
"""Characters of a value: each property could double that of the one before."""
_FORWARDED = "^"
"""How the default begins that is the value of the caller."""

Numbers = tuple[float, float, float]


class FixedJoint(NamedTuple):
    parent: str
    child: str
    where: Span
    xyz: Numbers | None
    """None where it is not known."""
    rpy: Numbers | None


@dataclass(slots=True)
class _Scope:
    """What the names in the body of a macro stand for."""

    values: dict[str, str | None] = field(default_factory=dict)
    """None for what is not known."""
    blocks: dict[str, tuple[Element, _Scope]] = field(default_factory=dict)
    """The elements that a call hands over, with the scope that they are written in."""


class XacroJoints:
    """``arguments``: those that the caller does not give, with their defaults."""

    def __init__(self, roots: list[Element], arguments: dict[str, str]) -> None:
        self._roots = roots
        self._arguments = arguments
        self._macros: dict[str, Element | None] = {}
        self._properties: dict[str, str | None] = {}
        self._left = _CALLS
        self._steps = 0
        """Properties that are being worked out, each for the one before."""
        for element in (each for root in roots for each in root.walk()):
            self._take(element)

    def _take(self, element: Element) -> None:
        """Remember a macro or a property; of those that are there twice nothing is known."""
        name = str(element.get("name")).rpartition(":")[2]
        if element.name == "xacro:macro":
            self._macros[name] = None if name in self._macros else element
        elif element.name == "xacro:property":
            value = element.get("value")
            known = self._properties.get(name, value)
            self._properties[name] = str(value) if value is not None and value == known else None

    def fixed(self) -> Iterator[FixedJoint]:
        for root in self._roots:
            yield from self._joints(root, _Scope(), None, 0)

    def _joints(self, outer: Element, scope: _Scope, called: Element | None, depth: int) -> Iterator[FixedJoint]:
        """``called``: the outermost call that leads here."""
        for element in outer.children:
            if element.name == "joint":
                yield from self._joint(element, scope, called)
            elif element.name.startswith("xacro:") and depth < _DEEP and self._left > 0:
                macro = self._macros.get(str(element.local))
                if macro is not None:
                    self._left -= 1
                    inner = self._called(macro, element, scope)
                    yield from self._joints(macro, inner, called or element, depth + 1)

    def _joint(self, element: Element, scope: _Scope, called: Element | None) -> Iterator[FixedJoint]:
        parent, child = self._end(element, "parent", scope), self._end(element, "child", scope)
        if element.get("type") == "fixed" and parent and child:
            origin, place = self._origin(element, scope)
            yield FixedJoint(
                parent,
                child,
                (called or element).tag,
                self._numbers(origin, "xyz", place),
                self._numbers(origin, "rpy", place),
            )

    def _end(self, joint: Element, name: str, scope: _Scope) -> str | None:
        end = joint.find(name)
        link = end.get("link") if end is not None else None
        return self._text(str(link), scope) if link is not None else None

    def _origin(self, joint: Element, scope: _Scope) -> tuple[Element | None, _Scope | None]:
        """The place of a joint, with the scope in which it is written; no scope where it is not known."""
        for child in joint.children:
            if child.name == "xacro:insert_block":
                block = scope.blocks.get(str(child.get("name")))
                return block if block is not None and block[0].name == "origin" else (None, None)
            if child.name.startswith("xacro:"):
                return None, None
        return joint.find("origin"), scope

    def _called(self, macro: Element, call: Element, scope: _Scope) -> _Scope:
        inner = _Scope()
        blocks = iter(call.children)
        for match in _PARAMETER.finditer(str(macro.get("params") or "")):
            name, default = match["name"], match["default"]
            given = call.get(name)
            if match["block"]:
                block = next(blocks, None)
                if block is not None and match["block"] == "*":
                    inner.blocks[name] = block, scope
            elif given is not None:
                inner.values[name] = self._text(str(given), scope)
            else:
                is_known = default is not None and not default.startswith(_FORWARDED)
                inner.values[name] = self._text(default.strip("'\""), scope) if is_known else None
        return inner

    def _numbers(self, origin: Element | None, name: str, scope: _Scope | None) -> Numbers | None:
        if scope is None:
            return None
        written = origin.get(name) if origin is not None else None
        text = self._text(str(written), scope) if written is not None else "0 0 0"
        try:
            x, y, z = (float(word) for word in (text or "").split())
        except ValueError:
            return None
        return x, y, z

    def _text(self, text: str, scope: _Scope) -> str | None:
        """A text with what its substitutions stand for; None when that is not known."""
        parts: list[str] = []
        end = 0
        for match in _SUBSTITUTION.finditer(text):
            argument = match["argument"]
            value = self._arguments.get(argument) if argument else self._expression(match["expression"], scope)
            if value is None:
                return None
            parts += text[end : match.start()], value
            end = match.end()
        found = "".join((*parts, text[end:]))
        return None if "$" in found or len(found) > _LONG else found

    def _expression(self, expression: str, scope: _Scope) -> str | None:
        """The value of a name, or of a sum of numbers and names."""
        name = expression.strip()
        if name in scope.values or name in self._properties:
            return self._value(name, scope)
        words = {word: self._value(word, scope) for word in _WORD.findall(expression)}
        try:
            numbers = {word: float(value or "") for word, value in words.items()}
            return str(evaluate(_WORD.sub(lambda word: repr(numbers[word[0]]), expression)))
        except (NotEvaluated, ValueError):
            return None

    def _value(self, name: str, scope: _Scope) -> str | None:
        if name in scope.values:
            return scope.values[name]
        if name in self._properties:
            return self._property(name)
        return str(math.pi) if name in ("pi", "math.pi") else None

    def _property(self, name: str) -> str | None:
        """The value of a property, worked out once; None for one that needs itself, or others over many steps."""
        value = self._properties[name]
        if value is not None and "$" in value:
            self._properties[name] = None
            self._steps += 1
            if self._steps < _STEPS:
                self._properties[name] = self._text(value, _Scope())
            self._steps -= 1
        return self._properties[name]
