"""The values that xacro may put for a variable of a robot description, as far as the tree gives them."""

from __future__ import annotations

from collections.abc import Iterator
from itertools import product
from typing import TYPE_CHECKING

from bringup_lint.pattern import regex

if TYPE_CHECKING:
    from bringup_lint.model.xml import Element

HOLE = "\0"
"""What stands for a part of a name that is not known."""
_SUBSTITUTION = regex(r"\$\{(?P<variable>[^{}]*)\}|\$\([^()]*\)")
_NAME = regex(r"\s*[A-Za-z_]\w*\s*\Z")
_PARAMETER = regex(r"(?P<name>[A-Za-z_]\w*)(?:\s*:=\s*(?P<default>'[^']*'|\"[^\"]*\"|[^\s'\"]+))?")
_DEEP = 8
"""Macros within macros that are followed."""
_MOST = 200
"""Names that one text may become."""
_STEPS = 200_000
"""Calls and properties that are looked at for all names; what is left then is not known."""


class XacroValues:
    """Gathers properties and calls of macros while files are read, and answers with the values that they give."""

    def __init__(self) -> None:
        self._calls: dict[str, list[Element]] = {}
        """Macro -> its calls."""
        self._properties: dict[str, list[Element]] = {}
        self._known: dict[tuple[str, Element | None, int], set[str]] = {}
        """Variable, its macro and the depth -> its values: a macro may call itself many times."""
        self._parameters: dict[Element, dict[str, str | None]] = {}
        self._left = _STEPS

    def take(self, root: Element) -> None:
        """Remember the calls and properties of a description."""
        for element in root.walk():
            if element.name == "xacro:property":
                self._properties.setdefault(str(element.get("name")), []).append(element)
            elif element.name.startswith("xacro:"):
                self._calls.setdefault(str(element.local), []).append(element)

    def names(self, text: str, element: Element, depth: int = 0) -> set[str]:
        """What a text at an element may become, with ``HOLE`` for what is not known."""
        parts: list[set[str]] = []
        end = 0
        for match in _SUBSTITUTION.finditer(text):
            parts += [{text[end : match.start()]}, self._values(match["variable"], element, depth)]
            end = match.end()
        parts.append({text[end:]})
        count = 1
        for part in parts:
            count *= len(part)
            if count > _MOST:
                return {_SUBSTITUTION.sub(HOLE, text)}
        return {"".join(each) for each in product(*parts)}

    def _values(self, variable: str | None, element: Element, depth: int) -> set[str]:
        if variable is None or not _NAME.match(variable) or depth > _DEEP:
            return {HOLE}
        name = variable.strip()
        macro = self._macro_around(element, name)
        key = (name, macro, depth)
        if key not in self._known:
            self._known[key] = self._given(name, macro, depth)
        return self._known[key]

    def _given(self, name: str, macro: Element | None, depth: int) -> set[str]:
        found: set[str] = set()
        for text, place in self._of_parameter(macro, name) if macro is not None else self._of_property(name):
            self._left -= 1 + len(place.attributes)
            if self._left < 0:
                return {HOLE}
            found |= {HOLE} if text is None else self.names(text, place, depth + 1)
        return found or {HOLE}

    def _of_parameter(self, macro: Element, name: str) -> Iterator[tuple[str | None, Element]]:
        """What the calls of a macro give for a parameter, or its default."""
        default = self._parameters_of(macro).get(name)
        for call in self._calls.get(str(macro.get("name")).rpartition(":")[2], ()):
            given = call.get(name)
            yield (str(given), call) if given is not None else (default, macro.parent or macro)

    def _of_property(self, name: str) -> Iterator[tuple[str | None, Element]]:
        for element in self._properties.get(name, ()):
            value = element.get("value")
            yield (str(value) if value is not None else None), element.parent or element

    def _macro_around(self, element: Element, name: str) -> Element | None:
        """The macro around an element that has a parameter."""
        macros = (each for each in (element, *element.ancestors) if each.name == "xacro:macro")
        return next((each for each in macros if name in self._parameters_of(each)), None)

    def _parameters_of(self, macro: Element) -> dict[str, str | None]:
        if macro not in self._parameters:
            self._parameters[macro] = _parameters(macro)
        return self._parameters[macro]


def _parameters(macro: Element) -> dict[str, str | None]:
    """Parameter of a macro -> its literal default."""
    found = {}
    for match in _PARAMETER.finditer(str(macro.get("params") or "")):
        default = match["default"]
        found[match["name"]] = default.strip("'\"") if default is not None and default[0] not in "^" else None
    return found
