"""Texts that the log macros of a C++ file take as formats, although they come from elsewhere."""

from __future__ import annotations

import re
from collections.abc import Iterator

from bringup_lint.model.cpp_source import FormatText
from bringup_lint.parsers.cpp_node.syntax import Code
from bringup_lint.pattern import regex

_LOG = regex(r"RCLCPP_(?:DEBUG|INFO|WARN|ERROR|FATAL)(?:_ONCE)?\Z")
_TEXT = regex(r"[A-Za-z_][\w:.>()\[\]-]{0,200}(?:->|\.)(?:what|c_str)\(\)\Z")
_FOREIGN = regex(r"(?i)\b(?:msg|request|req|goal|result)\w*->")
"""What comes from another node."""
_PLAIN = regex(r"\"[^\"%\n]*\"[)}]?\Z|(?:std::)?to_string\([^()%\"]*\)[)}]?\Z")


def format_texts(code: Code) -> Iterator[FormatText]:
    for call in code.calls:
        if len(call.arguments) == 2 and _LOG.match(call.name):
            text = "".join(code.text(call.arguments[1]).split())
            if _TEXT.match(text) and not _is_plain(code, text.removesuffix(".c_str()")):
                yield FormatText(code.span(call.arguments[1]), call.name, text, _FOREIGN.match(text) is not None)


def _is_plain(code: Code, name: str) -> bool:
    """Whether a variable of the file only ever gets a text without a ``%`` that is written there, or a number."""
    if not name.isidentifier():
        return False
    name = re.escape(name)
    given = re.findall(rf"\b{name}\s*(?:\+?=(?!=)|[({{])\s*([^;]{{0,200}})", code.source.text)
    return bool(given) and all(_PLAIN.match(each.strip()) for each in given)
