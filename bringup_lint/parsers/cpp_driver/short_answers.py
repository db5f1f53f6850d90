"""Answers of a device that a C++ file takes apart at fixed places, however long they are."""

from __future__ import annotations

import re
from collections.abc import Iterator
from itertools import islice

from bringup_lint.model.cpp_driver import ShortAnswer
from bringup_lint.model.cpp_text import blanked
from bringup_lint.parsers.cpp_driver.cut_answers import ANSWER
from bringup_lint.parsers.cpp_driver.cut_answers import givers
from bringup_lint.parsers.cpp_node.syntax import Code
from bringup_lint.pattern import regex
from bringup_lint.source import Span

TAKES_PARTS = regex(r"\bsplit\w{0,20}\s{0,4}\(|\.substr\s{0,4}\(\s{0,4}[1-9]", hints="split substr")
MOST = 20
"""Answers of one function that are looked at."""
_SPLIT = regex(
    r"\bsplit\s{0,4}\(\s{0,4}(?P<into>\w{1,60})\s{0,4},|\b(?:vector<\s{0,4}(?:std::)?string\s{0,4}>|auto)\s{1,4}"
    r"(?P<made>\w{1,60})\s{0,4}=\s{0,4}(?:\w{1,40}::){0,3}\w{0,40}[sS]plit\w{0,20}\s{0,4}\("
)
_READS = regex(r"(?:\.|->)\s{0,4}(?:ReadLine|readline|read_until)\s{0,4}\(|\bread_until\s{0,4}\(")
"""What reads a line of a device, which may be cut short."""
_TAKES = regex(r"\bcatch\s{0,4}\(\s{0,4}(?:\.\.\.|(?:const\s{1,4})?std::(?:exception|logic_error|out_of_range)\b)")
_LOOKS = (
    r"\b{0}\s{{0,4}}\.\s{{0,4}}(?:empty|size|length|at|find|rfind|compare|front|back|starts_with|resize)\b"
    r"|\b{0}\s{{0,4}}(?:[!=]=|\[\s{{0,4}}0)|[(,]\s{{0,4}}{0}\s{{0,4}}[,)]|\b{0}\s{{0,4}}\.\s{{0,4}}substr\s{{0,4}}\(\s{{0,4}}0\b"
    r"|\b{0}\s{{0,4}}\.\s{{0,4}}(?:c_str|data)\s{{0,4}}\(\s{{0,4}}\)\s{{0,4}},"
)
"""What may tell how long an answer is, or that it is another."""


def short_answers(code: Code) -> Iterator[ShortAnswer]:
    """One for each function that looks at nothing, with all its places."""
    bodies = [(each, body) for each in code.written.get("function", ()) if (body := each.child_by_field_name("body"))]
    known: dict[str, Span] | None = None
    for function, body in bodies:
        if not TAKES_PARTS.search(code.text(body)):
            continue
        text = blanked(code.text(body))
        fields = list(_fields(text))
        found = fields
        if not fields and ANSWER.search(text):
            known = givers(code, bodies) if known is None else known
            found = list(_parts(text, known))
        if found:
            start = code.span(body).start
            called = (code.defined_name(function) or "").rpartition("::")[2]
            spans = tuple(code.source.span(start + each.start(), start + each.end()) for each, _ in found)
            yield ShortAnswer(spans, found[0][1], called, bool(fields))


def _fields(text: str) -> Iterator[tuple[re.Match[str], str]]:
    """The fields behind the first of lines that are read here, when nothing asks how many there are."""
    if not _READS.search(text):
        return
    splits = list(islice(_SPLIT.finditer(text), MOST + 1))
    for split, end in zip(splits, [*(each.start() for each in splits[1:]), len(text)][:MOST]):
        name = split["into"] or split["made"]
        if not re.search(rf"\b{name}\s{{0,4}}\.\s{{0,4}}(?:empty|size|length|at|resize)\b", text):
            field = re.compile(rf"\b{name}\s{{0,4}}\[\s{{0,4}}[1-9]\d{{0,2}}\s{{0,4}}\]")
            used = field.search(text, split.end(), end)
            if used is not None:
                yield used, name


def _parts(text: str, known: dict[str, Span]) -> Iterator[tuple[re.Match[str], str]]:
    """What is cut off answers from a fixed place on, when nothing asks how long they are."""
    if _TAKES.search(text):
        return
    for answer in islice((each for each in ANSWER.finditer(text) if each["call"] in known), MOST):
        name = re.escape(answer["name"])
        part = re.compile(rf"\b{name}\s{{0,4}}\.\s{{0,4}}substr\s{{0,4}}\(\s{{0,4}}[1-9]\d{{0,2}}\s{{0,4}}[,)]")
        used = part.search(text, answer.end())
        if used is not None and not re.search(_LOOKS.format(name), text):
            yield used, answer["name"]
