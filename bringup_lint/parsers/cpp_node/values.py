"""What names mean in a C++ file: types through ``using``, constants, and variables that one parameter fills."""

from __future__ import annotations

import re
from functools import cached_property
from typing import TYPE_CHECKING

from bringup_lint.named_tuple import NamedTuple
from bringup_lint.parsers.cpp_node.syntax import Call
from bringup_lint.parsers.cpp_node.syntax import Code
from bringup_lint.pattern import regex
from bringup_lint.source import Located

if TYPE_CHECKING:
    from tree_sitter import Node

_INTERFACE = regex(r"(?P<package>\w+)::(?P<kind>msg|srv|action)::(?P<type>\w+)\Z")
_IDENTIFIER = regex(r"[A-Za-z_]\w*\Z")
_DECLARING = ("declare_parameter", "declare_parameter_if_not_declared")
_TEXT = regex(r"\)(?:\.get_parameter_value\(\))?\.(?:as_string|(?:get_value|get)<std::string>)\(\)\Z", hints=")")
"""How a call ends that gives the text of the parameter that it begins with."""


_DEFINE = regex(
    r"^[ \t]*#[ \t]*define[ \t]+(?P<name>[A-Za-z_]\w*)(?:\([ \t]*(?P<parameter>[A-Za-z_]\w*)[ \t]*\))?[ \t]+"
    r"(?P<body>[\w\"][^\n\\]{0,200})$",
    re.M,
    hints="define",
)
_MACRO_CALL = regex(r"(?P<name>[A-Za-z_]\w*)\s*\(\s*(?P<given>\"[^\"\\\n]{0,255}\")\s*\)\Z")
_PART = regex(r"\"[^\"\\\n]*\"|\w+")
_MOST_PARTS = 20
"""Literals of which a name is put together."""


class Macro(NamedTuple):
    """``parameter``: the only one of a macro that takes some."""

    parameter: str | None
    body: str


class FromParameter(NamedTuple):
    parameter: Located
    default: Located | None
    """None when it is not a literal."""


class Names:
    """The names of one file."""

    def __init__(self, code: Code) -> None:
        self.code = code

    @cached_property
    def _aliases(self) -> dict[str, str]:
        found: dict[str, str] = {}
        for node in self.code.written.get("alias", ()):
            name = self.code.text(node.child_by_field_name("name"))
            found[name] = "".join(self.code.text(node.child_by_field_name("type")).split())
        for node in self.code.written.get("using", ()):
            words = self.code.text(node).rstrip(";").split()
            if len(words) == 2 and "::" in words[1]:
                found[words[1].rpartition("::")[2]] = words[1]
        return found

    def interface(self, call: Call) -> str | None:
        """``geometry_msgs/msg/Twist`` for the first template argument of a call."""
        given = call.template.named_children if call.template is not None else []
        return self.type(self.code.text(given[0])) if given else None

    def type(self, written: str) -> str | None:
        """``geometry_msgs/msg/Twist`` for a type as it is written; None for what is no interface."""
        text = "".join(written.split()).lstrip(":")
        for _ in range(4):
            head, colons, rest = text.partition("::")
            text = self._aliases[head] + colons + rest if head in self._aliases else text
        found = _INTERFACE.match(text.lstrip(":"))
        return f"{found['package']}/{found['kind']}/{found['type']}" if found else None

    @cached_property
    def _values(self) -> dict[str, list[Node | None]]:
        """Variable or member -> what is assigned to it."""
        found: dict[str, list[Node | None]] = {}
        for node in self.code.written.get("assignment", ()):
            name = self.code.text(node.child_by_field_name("left")).removeprefix("this->")
            found.setdefault(name, []).append(node.child_by_field_name("right"))
        for node in self.code.written.get("made", ()):
            name = self.code.text(node.child_by_field_name("declarator")).lstrip("*& ").removesuffix("[]")
            found.setdefault(name, []).append(node.child_by_field_name("value"))
        return found

    def constant(self, name: str) -> Located | None:
        """The literal that a variable is made with and keeps."""
        values = self._values.get(name, [])
        if not _IDENTIFIER.match(name) or len(values) != 1 or name in self._filled:
            return None
        return self.code.literal(values[0])

    @cached_property
    def _filled(self) -> dict[str, list[Located]]:
        """Variable -> the parameters that give it a value."""
        found: dict[str, list[Located]] = {}
        for call in self.code.calls:
            name = self.code.literal(call.arguments[0]) if call.arguments else None
            if call.name in _DECLARING and len(call.arguments) > 1 and name is None:
                name = self.code.literal(call.arguments[1])
            if name is None or call.name not in (*_DECLARING, "get_parameter", "get_parameter_or"):
                continue
            if call.name.startswith("get_parameter") and len(call.arguments) > 1:
                target: str | None = self.code.text(call.arguments[1]).removeprefix("this->")
            else:
                target = self.code.kept(call.node)
            if target:
                found.setdefault(target, []).append(name)
        return found

    @cached_property
    def defaults(self) -> dict[str, list[Located | None]]:
        """Parameter -> the literal text with which it is declared."""
        found: dict[str, list[Located | None]] = {}
        for call in self.code.calls:
            if call.name in _DECLARING:
                name, default = declared(self.code, call)
                if name is not None:
                    found.setdefault(str(name), []).append(self.code.literal(default))
        return found

    def from_parameter(self, variable: str) -> FromParameter | None:
        """What a variable gets that only one parameter gives a value; None for any other."""
        names = self._filled.get(variable.removeprefix("this->"), [])
        if len({str(name) for name in names}) != 1:
            return None
        others = [value for value in self._values.get(variable, []) if not self._is_read(value, str(names[0]))]
        if any(self.code.literal(value) is None for value in others):
            return None
        return FromParameter(names[0], self._default(names[0]))

    def _is_read(self, value: Node | None, parameter: str) -> bool:
        """Whether an assigned value is a call that mentions a parameter."""
        return f'"{parameter}"' in self.code.text(value)

    def of_name(self, node: Node | None) -> tuple[Located | None, Located | None]:
        """The name that an argument gives, and the parameter that it comes from."""
        literal = self.code.literal(node) or self._joined(node)
        if literal is not None:
            return literal, None
        variable = self.code.text(node).removeprefix("this->")
        is_call = node is not None and node.type == "call_expression" and _TEXT.search(variable) is not None
        read = self._reads.get(node.start_byte) if node is not None and is_call else None
        if read is not None:
            return self._default(read), read
        found = self.from_parameter(variable)
        if found is not None:
            return found.default, found.parameter
        return self.constant(variable), None

    def _joined(self, node: Node | None) -> Located | None:
        """The text of literals side by side, and of macros that stand for such: ``PREFIX "state"``, ``TOPIC("state")``,
        placed at the whole."""
        if node is None or node.type not in ("concatenated_string", "call_expression", "identifier"):
            return None
        written = self.code.text(node)
        call = _MACRO_CALL.match(written)
        name = call["name"] if call is not None else written
        macro = self._macros.get(name)
        if macro is not None and (call is not None) == (macro.parameter is not None):
            given = call["given"] if call is not None else ""
            written = macro.body.replace(macro.parameter, given) if macro.parameter else macro.body
        elif node.type != "concatenated_string":
            return None
        parts: list[str] = []
        for part in _PART.findall(written)[: _MOST_PARTS + 1]:
            inner = self._macros.get(part)
            parts += _PART.findall(inner.body) if inner is not None and inner.parameter is None else [part]
        if (
            len(parts) > _MOST_PARTS
            or _PART.sub("", written).strip()
            or any(not part.startswith('"') for part in parts)
        ):
            return None
        return Located("".join(part[1:-1] for part in parts), self.code.span(node))

    @cached_property
    def _macros(self) -> dict[str, Macro]:
        """The macros of the file with a name of one meaning whose text may be one of literals."""
        found: dict[str, list[Macro]] = {}
        for each in _DEFINE.finditer(self.code.source.text):
            found.setdefault(each["name"], []).append(Macro(each["parameter"], each["body"].strip()))
        return {name: macros[0] for name, macros in found.items() if len(macros) == 1}

    @cached_property
    def _reads(self) -> dict[int, Located]:
        """Where an expression begins that asks for a parameter -> its name."""
        asking = (call for call in self.code.calls if call.name == "get_parameter" and call.arguments)
        named = ((call.node.start_byte, self.code.literal(call.arguments[0])) for call in asking)
        return {start: name for start, name in named if name is not None}

    def _default(self, parameter: Located) -> Located | None:
        """The text with which a parameter is declared, where all declarations say the same."""
        defaults = self.defaults.get(str(parameter), [])
        return defaults[0] if len({str(each) for each in defaults}) == 1 else None


def declared(code: Code, call: Call) -> tuple[Located | None, Node | None]:
    """The literal name and the default of a declaration; functions of nav2 take the node first."""
    given = call.arguments
    name = code.literal(given[0]) if given else None
    if name is None and call.name == "declare_parameter_if_not_declared" and len(given) > 1:
        given = given[1:]
        name = code.literal(given[0])
    return name, given[1] if len(given) > 1 else None
