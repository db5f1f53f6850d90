"""Answers of a device that a C++ file takes apart although they may be empty or cut short."""

from __future__ import annotations

import re
from collections.abc import Iterator
from typing import TYPE_CHECKING

from bringup_lint.model.cpp_driver import CutAnswer
from bringup_lint.model.cpp_text import blanked
from bringup_lint.parsers.cpp_node.syntax import Code
from bringup_lint.pattern import regex
from bringup_lint.source import Span

if TYPE_CHECKING:
    from tree_sitter import Node

TAKES_APART = regex(r"\.substr\s{0,4}\(", hints="substr")
ANSWER = regex(
    r"\b(?:string|auto)\s{1,4}(?P<name>\w{1,60})\s{0,4}(?:=\s{0,4}|[({]\s{0,4})"
    r"(?:this->)?(?P<call>(?i:\w{0,40}(?:send|msg|message|query|request|exchange|command|receive|write_?read)\w{0,40}))"
    r"\s{0,4}\("
)
"""A text that a call which sends something gives back."""
_SOUGHT = r"\b(?P<at>\w{{1,60}})\s{{0,4}}=\s{{0,4}}{0}\s{{0,2}}\.\s{{0,2}}find\s{{0,2}}\("
_PART = r"\b{0}\s{{0,2}}\.\s{{0,2}}substr\s{{0,2}}\(\s{{0,4}}(?:0\s{{0,2}},\s{{0,2}}{1}\b|{1}\s{{0,2}}\+)"
_NUMBER = regex(r"\b(?:std::)?(?P<reads>ato(?:i|f|l|ll)|strto(?:l|d|f|ul))\s{0,2}\(")
_LOOKS = (
    r"\bnpos\b|\b(?:try|catch)\b|\b{0}\s{{0,2}}(?:\.\s{{0,2}}(?:empty|size|length|back|front)\b|[!=]=)"
    r"|\bif\s{{0,2}}\([^;{{}}]{{0,80}}\b(?:{0}|{1})\b"
)
"""What asks whether there is an answer, or whether something was found in it."""
_SILENT = regex(
    r"\bcatch\s{0,4}\([^(){}]{0,120}\)\s{0,40}\{(?![^{}]{0,600}\b(?:throw|return\s+(?:false|-1)|exit|abort)\b)"
    r"|\.\s{0,2}readline\s{0,2}\(|(?<![\w.>])(?:::)?(?:read|recv)\s{0,2}\("
)
"""What leaves a text empty when nothing comes in time."""


def cut_answers(code: Code) -> Iterator[CutAnswer]:
    """One for each function that takes an answer apart and looks at nothing."""
    bodies = [(each, body) for each in code.written.get("function", ()) if (body := each.child_by_field_name("body"))]
    known: dict[str, Span] | None = None
    for function, body in bodies:
        text = blanked(code.text(body)) if TAKES_APART.search(code.text(body)) else ""
        found = ANSWER.search(text)
        number = _NUMBER.search(text)
        if found is None or number is None:
            continue
        place = _part(text, found["name"])
        if place is not None and known is None:
            known = givers(code, bodies)
        given = known.get(found["call"]) if known is not None else None
        if place is not None and given is not None:
            start = code.span(body).start
            span = code.source.span(start + place[0], start + place[1])
            name = (code.defined_name(function) or "").rpartition("::")[2]
            yield CutAnswer(span, given, found["name"], name, number["reads"])


def _part(text: str, name: str) -> tuple[int, int] | None:
    """Where a function cuts a part off a text at what it sought there, and looks at neither."""
    name = re.escape(name)
    sought = re.search(_SOUGHT.format(name), text)
    if sought is None or re.search(_LOOKS.format(name, re.escape(sought["at"])), text):
        return None
    part = re.search(_PART.format(name, re.escape(sought["at"])), text)
    return part.span() if part is not None else None


def givers(code: Code, bodies: list[tuple[Node, Node]]) -> dict[str, Span]:
    """The functions of the file that give an answer, each with where it goes on without one."""
    givers: dict[str, Span] = {}
    for function, body in bodies:
        found = _SILENT.search(blanked(code.text(body)))
        if found is not None:
            start = code.span(body).start
            name = (code.defined_name(function) or "").rpartition("::")[2]
            givers.setdefault(name, code.source.span(start + found.start(), start + found.end()))
    return givers
