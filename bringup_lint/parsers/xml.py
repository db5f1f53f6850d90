"""The one XML reader: text to a located tree, without entities, DTDs, network or surprises.

It accepts what XML 1.0 with namespaces calls well-formed and reports everything else as a problem, then
goes on: a
missing end tag is closed by the end tag of an element around it, a stray one is skipped. Time is linear,
depth and size are
bounded. A DOCTYPE is always a problem, and its declarations have no effect.

Problem codes: ``bad-attribute``, ``bad-comment``, ``bad-declaration``, ``bad-instruction``,
``bad-reference``, ``bad-tag``, ``cdata-end``, ``control-character``, ``doctype``, ``duplicate-attribute``,
``empty-document``, ``encoding``, ``entity``, ``late-declaration``, ``less-than-in-value``,
``mismatched-tag``, ``missing-blank``, ``second-root``, ``stray-end-tag``, ``text-outside-root``,
``too-deep``, ``too-large``, ``too-many-problems``, ``unclosed-element``, ``unclosed-markup``,
``unclosed-tag``, ``undeclared-prefix``.
"""

from __future__ import annotations

import re
from collections import Counter

from bringup_lint.model.xml import Document
from bringup_lint.model.xml import Element
from bringup_lint.parsers.xml_tags import StartTag
from bringup_lint.parsers.xml_tags import name_at
from bringup_lint.parsers.xml_tags import start_tag
from bringup_lint.parsers.xml_text import FORBIDDEN
from bringup_lint.parsers.xml_text import decode
from bringup_lint.pattern import regex
from bringup_lint.source import Located
from bringup_lint.source import Problem
from bringup_lint.source import Source
from bringup_lint.source import Span

MAX_SIZE = 4_000_000
"""Code points; far above any configuration file."""
MAX_DEPTH = 200
MAX_ELEMENTS = 30_000
MAX_PROBLEMS = 50

_BLANK = " \t\r\n"
_END_TAG = regex(r"</([^ \t\r\n<>]*)[ \t\r\n]*(>?)")
_DECLARATION = regex(
    r"<\?xml[ \t\r\n]+version[ \t\r\n]*=[ \t\r\n]*(?:\"1\.[0-9]+\"|'1\.[0-9]+')"
    r"(?:[ \t\r\n]+encoding[ \t\r\n]*=[ \t\r\n]*"
    r"(?:\"(?P<double>[A-Za-z][\w.-]*)\"|'(?P<single>[A-Za-z][\w.-]*)'))?"
    r"(?:[ \t\r\n]+standalone[ \t\r\n]*=[ \t\r\n]*(?:\"(?:yes|no)\"|'(?:yes|no)'))?[ \t\r\n]*\?>",
    re.ASCII,
)
_TEXT_ENCODINGS = {"utf-8", "utf8", "us-ascii", "ascii"}
_DOCTYPE_MARK = regex(r"[\[\]<>\"']")


def parse(source: Source, start: int = 0, end: int | None = None) -> Document:
    """Read any text, or a stretch of one; never raises."""
    return _Reader(source, start, len(source.text) if end is None else end).read()


class _Reader:
    def __init__(self, source: Source, start: int, end: int) -> None:
        self.source = source
        self.text = source.text[:end]
        self.document = Document(source)
        self.open: list[Element] = []
        self.declared: list[list[str]] = []
        self.prefixes = Counter(("xml", "xmlns"))
        self.begin = start + 1 if self.text.startswith("\ufeff", start) else start
        self.at = self.begin
        self.stopped = False
        self.count = 0

    def report(self, code: str, start: int, end: int, detail: str = "") -> None:
        if len(self.document.problems) == MAX_PROBLEMS:
            self.stop("too-many-problems", start, "the rest of the file is not read")
        if not self.stopped:
            self.document.problems.append(Problem(code, self.source.span(start, end), detail))

    def stop(self, code: str, start: int, detail: str) -> None:
        if not self.stopped:
            self.document.problems.append(Problem(code, self.source.span(start, start), detail))
        self.stopped = True

    def read(self) -> Document:
        if len(self.text) > MAX_SIZE:
            self.stop("too-large", 0, f"more than {MAX_SIZE} characters")
        else:
            bad = FORBIDDEN.search(self.text, self.at)
            if bad:
                self.report("control-character", bad.start(), bad.end(), f"U+{ord(bad[0]):04X}")
            self.declaration()
        while self.at < len(self.text) and not self.stopped:
            self.step()
        if not self.stopped:
            for element in reversed(self.open):
                self.report("unclosed-element", element.name.span.start, element.name.span.end, element.name)
            if self.document.root is None and not self.document.problems:
                self.report("empty-document", len(self.text), len(self.text), "no element")
        while self.open:
            self.close(self.open[-1], min(self.at, len(self.text)))
        return self.document

    def declaration(self) -> None:
        match = _DECLARATION.match(self.text, self.at)
        if match is None:
            return
        self.document.declaration = self.source.span(*match.span())
        encoding = match["double"] or match["single"] or "utf-8"
        if encoding.lower() not in _TEXT_ENCODINGS and not self.fits(encoding):
            self.report("encoding", *match.span(), f"says {encoding}, but the file was read as UTF-8")
        self.at = match.end()

    def fits(self, encoding: str) -> bool:
        """Whether a file that says it has this encoding means the same when it is read as UTF-8."""
        try:
            return self.text.isascii() and "<".encode(encoding) == b"<"
        except (LookupError, ValueError, TypeError):
            return False

    def step(self) -> None:
        text, at = self.text, self.at
        if text[at] != "<":
            self.character_data()
        elif text.startswith("</", at):
            self.end_tag()
        elif text.startswith("<!--", at):
            end = self.skip("-->", at + 4, "comment")
            if text.find("--", at + 4, end - 2) != -1:
                self.report("bad-comment", at, end, "-- inside a comment")
        elif text.startswith("<![CDATA[", at):
            end = self.skip("]]>", at + 9, "CDATA section")
            if self.open:
                self.open[-1].texts.append(self.source.located(at + 9, max(at + 9, end - 3)))
            else:
                self.report("text-outside-root", at, end)
        elif text.startswith("<!", at):
            self.doctype()
        elif text.startswith("<?", at):
            self.instruction()
        else:
            self.start(at)

    def skip(self, closing: str, start: int, what: str) -> int:
        """Go behind ``closing``; without one, the rest of the file is lost."""
        end = self.text.find(closing, start)
        if end == -1:
            self.report("unclosed-markup", self.at, start, f"{what} has no {closing}")
            self.at = len(self.text)
            return self.at
        self.at = end + len(closing)
        return self.at

    def character_data(self) -> None:
        start = self.at
        end = self.text.find("<", start)
        self.at = end = len(self.text) if end == -1 else end
        if self.open:
            self.open[-1].texts.append(decode(self.source, start, end, self.report))
            bad = self.text.find("]]>", start, end)
            if bad != -1:
                self.report("cdata-end", bad, bad + 3, "]]> must be written ]]&gt;")
            return
        run = self.text[start:end]
        if run.strip(_BLANK):
            first = start + len(run) - len(run.lstrip(_BLANK))
            self.report("text-outside-root", first, start + len(run.rstrip(_BLANK)))

    def instruction(self) -> None:
        start = self.at
        name = name_at(self.text, start + 2)
        end = self.skip("?>", start + 2, "processing instruction")
        if name is None:
            self.report("bad-instruction", start, end, "no name")
        elif name[0] == "xml":
            first = start == self.begin
            code = "bad-declaration" if first else "late-declaration"
            self.report(code, start, end, "" if first else "it must be the first thing in the file")
        else:
            self.document.instructions.append(self.source.span(start, end))
        if name is None or name[0] == "xml":
            return
        if name[0].lower() == "xml" or ":" in name[0]:
            self.report("bad-instruction", start, end, f"{name[0]} is reserved")
        elif self.text[name.end() : name.end() + 1] not in (*_BLANK, "?", ""):
            self.report("bad-instruction", start, end, "a space is missing after the name")

    def doctype(self) -> None:
        """Step over a DOCTYPE with its internal subset."""
        start = self.at
        depth = 0
        at = start + 2
        while True:
            mark = _DOCTYPE_MARK.search(self.text, at)
            if mark is None:
                self.at = len(self.text)
                break
            at = mark.end()
            if mark[0] in "\"'":
                closing = self.text.find(mark[0], at)
                at = len(self.text) if closing == -1 else closing + 1
            elif mark[0] in "[<":
                depth += 1
            elif mark[0] == "]" or depth:
                depth = max(0, depth - 1)
            else:
                self.at = at
                break
        span = self.source.span(start, self.at)
        if self.text.startswith("<!DOCTYPE", start) and not self.open and self.document.root is None:
            self.document.doctype = span
            self.report("doctype", start, min(self.at, start + 9), "entities and external parts are never loaded")
        else:
            self.report("misplaced-declaration", start, min(self.at, start + 2), "not markup that is allowed here")

    def start(self, at: int) -> None:
        tag = start_tag(self.source, at, self.report)
        if tag is None:
            self.report("bad-tag", at, at + 1, "< must be written &lt;")
            self.at = at + 1
            return
        self.at = tag.end
        self.count += 1
        if self.count > MAX_ELEMENTS:
            self.stop("too-large", at, f"more than {MAX_ELEMENTS} elements")
            return
        if len(self.open) == MAX_DEPTH:
            self.stop("too-deep", at, f"more than {MAX_DEPTH} elements inside one another")
            return
        parent = self.open[-1] if self.open else None
        span = self.source.span(at, tag.end)
        element = Element(tag.name, tag.attributes, parent, span, span)
        if parent is not None:
            parent.children.append(element)
        elif self.document.root is None:
            self.document.root = element
        else:
            self.report("second-root", tag.name.span.start, tag.name.span.end, tag.name)
            self.document.others.append(element)
        self.open.append(element)
        self.declare(tag)
        if tag.closed:
            self.close(element, tag.end)

    def declare(self, tag: StartTag) -> None:
        """Open the scope of a tag's own prefixes, and check those that it uses."""
        names = [each.name for each in tag.attributes]
        declared = [name[6:] for name in names if name.startswith("xmlns:")]
        self.declared.append(declared)
        if declared:
            self.prefixes.update(declared)
        for name in (tag.name, *names):
            if ":" in name and not self.qualified(name):
                self.report("undeclared-prefix", name.span.start, name.span.end, name.partition(":")[0])
        for each in tag.attributes:
            if each.name.startswith("xmlns:") and not each.value:
                self.report("bad-attribute", each.name.span.start, each.value.span.end, "a prefix needs a namespace")

    def qualified(self, name: Located) -> bool:
        prefix, _, local = name.partition(":")
        return bool(prefix and local and ":" not in local and self.prefixes[prefix])

    def end_tag(self) -> None:
        match = _END_TAG.match(self.text, self.at)
        assert match is not None
        start, self.at = self.at, match.end()
        if not match[2]:
            self.report("unclosed-tag", start, match.end(), "'>' is missing")
        name = match[1]
        if not any(element.name == name for element in self.open[-MAX_DEPTH:]):
            self.report("stray-end-tag", start, self.at, name)
            return
        if self.open[-1].name != name:
            inner = self.open[-1].name
            self.report("mismatched-tag", start, self.at, f"{inner} is still open: </{inner}> expected")
        while self.open[-1].name != name:
            self.close(self.open[-1], start)
        self.close(self.open[-1], self.at)

    def close(self, element: Element, end: int) -> None:
        element.span = Span(self.source, element.span.start, end)
        self.open.pop()
        declared = self.declared.pop()
        if declared:
            self.prefixes.subtract(declared)
