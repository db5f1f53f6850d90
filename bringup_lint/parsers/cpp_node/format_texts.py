"""Texts that the log macros of a C++ file take as formats, although they come from elsewhere."""

from __future__ import annotations

from collections.abc import Iterator

from bringup_lint.model.cpp_source import FormatText
from bringup_lint.parsers.cpp_node.syntax import Code
from bringup_lint.pattern import regex

_LOG = regex(r"RCLCPP_(?:DEBUG|INFO|WARN|ERROR|FATAL)(?:_ONCE)?\Z")
_TEXT = regex(r"[A-Za-z_][\w:.>()\[\]-]{0,200}(?:->|\.)(?:what|c_str)\(\)\Z")
_FOREIGN = regex(r"(?i)\b(?:msg|request|req|goal|result)\w*->")
"""What comes from another node."""
_PLAIN = regex(r"\"[^\"%\n]*\"[)}]?\Z|(?:std::)?to_string\([^()%\"]*\)[)}]?\Z")
_GIVEN = regex(r"\b([A-Za-z_]\w*)(?=\s*(?:\+?=(?!=)|[({])\s*([^;]{0,200}))")


def format_texts(code: Code) -> Iterator[FormatText]:
    plain: dict[str, bool] | None = None
    for call in code.calls:
        if len(call.arguments) == 2 and _LOG.match(call.name):
            text = "".join(code.text(call.arguments[1]).split())
            if _TEXT.match(text):
                plain = _plain(code) if plain is None else plain
                if not plain.get(text.removesuffix(".c_str()"), False):
                    yield FormatText(code.span(call.arguments[1]), call.name, text, _FOREIGN.match(text) is not None)


def _plain(code: Code) -> dict[str, bool]:
    """Variable -> whether it only ever gets a text without a ``%`` that is written there, or a number."""
    found: dict[str, bool] = {}
    for match in _GIVEN.finditer(code.source.text):
        found[match[1]] = found.get(match[1], True) and _PLAIN.match(match[2].strip()) is not None
    return found
