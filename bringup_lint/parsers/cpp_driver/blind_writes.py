"""Files that a service of a C++ file writes without a look at whether it could, and answers with success."""

from __future__ import annotations

import re
from collections.abc import Iterator

from bringup_lint.model.cpp_driver import BlindWrite
from bringup_lint.model.cpp_text import blanked
from bringup_lint.parsers.cpp_node.syntax import Code
from bringup_lint.pattern import regex

WRITES = regex(r"\bofstream\b", hints="ofstream")
_OPENED = regex(r"\bofstream\s{1,4}(?P<name>\w+)\s{0,4}(?=[({;])")
ANSWERED = regex(r"\b(?P<answer>\w+)(?:->|\.)success\s{0,4}=\s{0,4}true\b", hints="success")
_LOOKS = (
    r"\b{0}\s{{0,4}}\.\s{{0,4}}(?:is_open|good|fail|bad|exceptions|rdstate|operator)\b|[!&|]\s{{0,4}}{0}\b"
    r"|\b(?:if|while)\s{{0,4}}\(\s{{0,4}}{0}\b|\bbool\s{{0,4}}\(\s{{0,4}}{0}\b|<bool>\s{{0,4}}\(\s{{0,4}}{0}\b"
    r"|[(,]\s{{0,4}}{0}\s{{0,4}}[,)]"
)
"""What asks a stream how it is, or hands it to something that may."""


def blind_writes(code: Code) -> Iterator[BlindWrite]:
    """The first for each function; of one in another the inner one."""
    found: dict[int, BlindWrite] = {}
    for function in (*code.written.get("function", ()), *code.written.get("lambda", ())):
        text = blanked(code.text(function))
        opened = _OPENED.search(text)
        answered = ANSWERED.search(text, opened.end()) if opened is not None else None
        if opened is not None and answered is not None:
            if not re.search(_LOOKS.format(re.escape(opened["name"])), text):
                start = code.span(function).start
                place, answer = (
                    code.source.span(start + each.start(), start + each.end()) for each in (opened, answered)
                )
                found[place.start] = BlindWrite(place, answer, opened["name"])
    yield from found.values()
