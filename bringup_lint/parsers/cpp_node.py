"""C++ sources of nodes: the topics whose names stand in them as text, with type and quality of service. No compiler:
what is not written out at the call stays unknown."""

from __future__ import annotations

import re
from collections.abc import Iterator
from dataclasses import dataclass
from dataclasses import field

from bringup_lint.model.node_source import Endpoint
from bringup_lint.model.node_source import Qos
from bringup_lint.parsers.cpp_names import from_parameter
from bringup_lint.parsers.cpp_qos import quality
from bringup_lint.parsers.cpp_text import arguments
from bringup_lint.parsers.cpp_text import blanked
from bringup_lint.parsers.cpp_text import template_end
from bringup_lint.parsers.cpp_text import trimmed
from bringup_lint.source import Located
from bringup_lint.source import Source
from bringup_lint.source import Span

_CREATE = re.compile(r"\bcreate_(?P<role>publisher|subscription)\s*<")
_NAME = re.compile(
    r"\b(?:rclcpp::|rclcpp_lifecycle::|nav2(?:_util)?::)?(?:Lifecycle)?Node\s*(?:::make_shared\s*)?[({]\s*\""
)
_MADE = re.compile(r"\bmake_(?:shared|unique)\s*<\s*(?:rclcpp::Node|rclcpp_lifecycle::LifecycleNode)\s*>\s*\(\s*\"")
_CLASS = re.compile(r"\b(?:class|struct)\s+(?P<name>\w+)[^;{(]*:[^;{(]*\b(?:Lifecycle)?Node\b[^;{(]*\{")
_COMPONENT = re.compile(r"\bRCLCPP_COMPONENTS_REGISTER_NODE\s*\(\s*(?P<name>[\w:]+)\s*\)")
_MESSAGE = re.compile(r"(?P<package>\w+)::msg::(?P<type>\w+)")
_ALIAS = re.compile(
    r"\busing\s+(?P<name>\w+)\s*=\s*(?P<full>\w+::msg::\w+)\s*;|\busing\s+(?P<other>\w+::msg::(?P<last>\w+))\s*;"
)


@dataclass(eq=False, slots=True)
class CppNode:
    source: Source
    endpoints: list[Endpoint] = field(default_factory=list)
    """In the order of the text; without a name where it is not a literal."""
    names: list[Located] = field(default_factory=list)
    """The literal names that nodes give themselves."""
    classes: list[str] = field(default_factory=list)
    """Classes that build on a node."""
    components: list[str] = field(default_factory=list)
    """Classes that are registered as components."""


def parse(source: Source) -> CppNode:
    node = CppNode(source)
    code, bare = blanked(source.text)
    for pattern in (_NAME, _MADE):
        for found in pattern.finditer(bare):
            end = bare.find('"', found.end())
            if end > 0:
                node.names.append(source.located(found.end(), end))
    node.classes = [found["name"] for found in _CLASS.finditer(bare)]
    node.components = [found["name"] for found in _COMPONENT.finditer(bare)]
    aliases = {found["name"] or found["last"]: found["full"] or found["other"] for found in _ALIAS.finditer(bare)}
    node.endpoints = list(_endpoints(source, code, bare, aliases))
    return node


def _endpoints(source: Source, code: str, bare: str, aliases: dict[str, str]) -> Iterator[Endpoint]:
    for found in _CREATE.finditer(bare):
        end = template_end(bare, found.end())
        opening = re.compile(r"\s*\(").match(bare, end + 1) if end is not None else None
        call = arguments(bare, opening.end()) if opening else None
        if call is None:
            continue
        spans = list(trimmed(code, call[0]))
        qos = _qos(source, code, bare, *spans[1]) if len(spans) > 1 else None
        type_ = _type(bare[found.end() : end], aliases)
        name = _literal(source, code, bare, *spans[0]) if spans else None
        given = from_parameter(source, code, code[slice(*spans[0])]) if spans and name is None else None
        yield Endpoint(
            found["role"],
            type_,
            name if given is None else given.default,
            None if given is None else given.parameter,
            qos,
            None,
            None,
            None,
            "Lifecycle" in bare,
            source.span(found.start(), call[1]),
            conditional=True,
        )


def _literal(source: Source, code: str, bare: str, start: int, end: int) -> Located | None:
    if re.fullmatch(r'" *"', bare[start:end]) and "\\" not in code[start:end] and code[start] == '"':
        return source.located(start + 1, end - 1)
    return None


def _type(text: str, aliases: dict[str, str]) -> str | None:
    text = re.sub(r"\s+", "", text).lstrip(":")
    found = _MESSAGE.fullmatch(aliases.get(text, text))
    return f"{found['package']}/msg/{found['type']}" if found else None


def _qos(source: Source, code: str, bare: str, start: int, end: int) -> Qos | None:
    text = code[start:end]
    span = source.span(start, end)
    if re.fullmatch(r"[A-Za-z_]\w*", text):
        return _variable(text, bare, span)
    return quality(text, span)


def _variable(name: str, bare: str, span: Span) -> Qos | None:
    """A local profile that is made once and not changed afterwards."""
    made = list(re.finditer(rf"\b(?:auto|(?:rclcpp::)?\w*QoS)\s+{name}\s*(?P<rest>[=({{][^;]*);", bare))
    if len(made) != 1 or re.search(rf"\b{name}\s*(?:\.|->|=(?!=))", bare[made[0].end() :]):
        return None
    rest = made[0]["rest"].strip()
    if rest.startswith("="):
        return quality(rest[1:], span)
    kind = re.search(r"(?:rclcpp::)?\w*QoS", made[0][0])
    return quality(f"{kind[0]}{rest}", span) if kind else None
