"""Topic names that a C++ source takes from a parameter: which parameter, and what is declared as its default."""

from __future__ import annotations

import re
from typing import NamedTuple

from bringup_lint.source import Located
from bringup_lint.source import Source

_DECLARED = re.compile(
    r"\bdeclare_parameter(?:_if_not_declared)?\s*(?:<\s*std::string\s*>)?\s*\(\s*(?:[\w.>-]+(?:\(\))?\s*,\s*)?"
    r"\"(?P<name>[\w./-]+)\"\s*,\s*(?:(?:rclcpp::ParameterValue|std::string)\s*[({]\s*){0,2}\"(?P<default>[^\"\\\n]*)\""
)
_CALL = r"(?:\w+(?:\(\))?\s*(?:->|\.)\s*)?"
_TAKEN = (
    rf"\b{{name}}\s*=\s*{_CALL}declare_parameter\s*(?:<\s*std::string\s*>)?\s*\(\s*\"(?P<declared>[\w./-]+)\"",
    r"\bget_parameter\s*\(\s*\"(?P<given>[\w./-]+)\"\s*,\s*{name}\s*\)",
    rf"\b{{name}}\s*=\s*{_CALL}get_parameter\s*\(\s*\"(?P<read>[\w./-]+)\"\s*\)\s*\.\s*(?:as_string|get_value<\s*std::string\s*>)\s*\(",
)
_IDENTIFIER = re.compile(r"[A-Za-z_]\w*\Z")


class FromParameter(NamedTuple):
    parameter: Located
    default: Located | None
    """None when it is not a literal."""


def from_parameter(source: Source, code: str, variable: str) -> FromParameter | None:
    """What a variable gets that only one parameter gives a value; None for any other. ``code``: without comments."""
    if not _IDENTIFIER.match(variable):
        return None
    found: dict[str, tuple[int, int]] = {}
    assigned = 0
    for pattern in _TAKEN:
        for match in re.finditer(pattern.replace("{name}", variable), code):
            group = match.lastgroup or ""
            found.setdefault(match[group], match.span(group))
            assigned += group != "given"
    if len(found) != 1 or len(re.findall(rf"\b{variable}\s*[+]?=(?!=)", code)) != assigned:
        return None
    ((name, span),) = found.items()
    defaults = {match["default"]: match.span("default") for match in _DECLARED.finditer(code) if match["name"] == name}
    default = source.located(*next(iter(defaults.values()))) if len(defaults) == 1 else None
    return FromParameter(source.located(*span), default)
