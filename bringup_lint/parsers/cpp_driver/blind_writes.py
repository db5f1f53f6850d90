"""Files that a service of a C++ file writes without a look at whether it could, and answers with success."""

from __future__ import annotations

import re
from bisect import bisect_left
from collections.abc import Iterator
from itertools import islice

from bringup_lint.model.cpp_driver import BlindWrite
from bringup_lint.model.cpp_text import plain_of
from bringup_lint.parsers.cpp_node.syntax import Code
from bringup_lint.pattern import regex

WRITES = regex(r"\bofstream\b", hints="ofstream")
MOST = 50
"""Functions of one file that are looked at."""
_OPENED = regex(r"\bofstream\s{1,4}(?P<name>\w+)\s{0,4}(?=[({;])")
ANSWERED = regex(r"\b(?P<answer>\w+)(?:->|\.)success\s{0,4}=\s{0,4}true\b", hints="success")
_LOOKS = (
    r"\b{0}\s{{0,4}}\.\s{{0,4}}(?:is_open|good|fail|bad|exceptions|rdstate|operator)\b|[!&|]\s{{0,4}}{0}\b"
    r"|\b(?:if|while)\s{{0,4}}\(\s{{0,4}}{0}\b|\bbool\s{{0,4}}\(\s{{0,4}}{0}\b|<bool>\s{{0,4}}\(\s{{0,4}}{0}\b"
    r"|[(,;]\s{{0,4}}{0}\s{{0,4}}[,)]|\b{0}\s{{0,4}}(?:\?|&&|\|\|)|\{{\s{{0,4}}{0}\s{{0,4}}\}}"
    r"|\b(?:if|while)\s{{0,4}}\(\s{{0,4}}(?:std::)?ofstream\s{{1,4}}{0}\b|\bexists\s{{0,4}}\("
)
"""What asks a stream how it is, hands it to something that may, or looks whether the file is there."""
_ASIDE = regex(r"(?i)log|debug|trace")
"""Names of files that no answer is about."""


def blind_writes(code: Code) -> Iterator[BlindWrite]:
    """The first for each function; of one in another the inner one."""
    plain = plain_of(code.source)
    found: dict[int, BlindWrite] = {}
    for start, end, opened, answered in islice(_writing(code, plain), MOST):
        if _ASIDE.search(opened["name"]):
            continue
        if not re.compile(_LOOKS.format(re.escape(opened["name"]))).search(plain, start, end):
            place, answer = (code.source.span(*each.span()) for each in (opened, answered))
            found[place.start] = BlindWrite(place, answer, opened["name"])
    yield from found.values()


def _writing(code: Code, plain: str) -> Iterator[tuple[int, int, re.Match[str], re.Match[str]]]:
    """The functions that open a stream and answer with success after that: where each begins and ends, and where it
    does both first."""
    opening, answering = (list(each.finditer(plain)) for each in (_OPENED, ANSWERED))
    starts, answers = ([each.start() for each in matches] for matches in (opening, answering))
    for function in (*code.written.get("function", ()), *code.written.get("lambda", ())):
        span = code.span(function)
        at = bisect_left(starts, span.start)
        opened = opening[at] if at < len(starts) else None
        after = bisect_left(answers, opened.end()) if opened is not None else len(answers)
        answered = answering[after] if after < len(answers) else None
        if opened is not None and answered is not None and answered.end() <= span.end:
            yield span.start, span.end, opened, answered
