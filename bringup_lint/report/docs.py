"""A rule's documentation: its docstring and its metadata as Markdown and as plain text."""

from __future__ import annotations

import re
from collections.abc import Iterator

from bringup_lint.report.model import RuleDoc
from bringup_lint.report.paint import Paint
from bringup_lint.report.paint import painter
from bringup_lint.report.wrap import wrap

HEADINGS = ("What it finds", "Why it matters on a robot", "Bad", "Good", "When to ignore it", "References")
"""The sections of a rule's documentation, in their order."""
LOG_LINES = "Log lines"
PROSE = 88
"""Prose is not set wider than this."""


def sections(docstring: str) -> dict[str, str]:
    """The text under each ``##`` heading, in the order of the docstring; code blocks have no headings."""
    from inspect import cleandoc

    found: dict[str, list[str]] = {}
    body: list[str] = []
    for line, code in _lines(cleandoc(docstring)):
        if line.startswith("## ") and not code:
            body = found.setdefault(line[3:].strip(), [])
        else:
            body.append(line)
    return {heading: "\n".join(lines).strip() for heading, lines in found.items()}


def markdown(doc: RuleDoc) -> str:
    """The page of a rule."""
    parts = [f"# {doc.id}", doc.title + ".", _facts(doc)]
    for heading, body in _all_sections(doc):
        parts += [f"## {heading}", body]
    return "\n\n".join(part for part in parts if part) + "\n"


def plain(doc: RuleDoc, width: int = 80, colour: bool = False) -> str:
    """The page for a terminal: paragraphs wrapped, code blocks indented."""
    paint = painter(colour)
    width = min(max(width, 40), PROSE)
    title = [paint("strong", line) for line in wrap(doc.title, width)]
    parts = ["\n".join((paint(str(doc.severity), doc.id), *title)), paint("faint", _facts(doc))]
    for heading, body in _all_sections(doc):
        parts.append("\n".join((paint("mark", heading), "", *_set(body, width, paint))).rstrip())
    return "\n\n".join(parts) + "\n"


def finds(doc: RuleDoc) -> str:
    """What the rule finds, in one line of plain text."""
    body = sections(doc.docstring).get(HEADINGS[0], "")
    prose = " ".join(line for line, code in _lines(body) if not code and not line.startswith("```"))
    return " ".join(_without_links(prose).replace("**", "").split()) or doc.title + "."


def _facts(doc: RuleDoc) -> str:
    facts = [str(doc.severity), f"confidence {doc.confidence}"]
    facts += [] if doc.fix == "none" else [f"{doc.fix} fix"]
    facts += [f"since {doc.since}"] if doc.since else []
    facts += [*doc.tags] + [f"also known as {alias}" for alias in doc.aliases]
    return " · ".join(facts)


def _all_sections(doc: RuleDoc) -> Iterator[tuple[str, str]]:
    found = sections(doc.docstring)
    references = found.pop(HEADINGS[-1], "")
    yield from found.items()
    if doc.symptoms:
        yield LOG_LINES, "\n".join(("```text", *doc.symptoms, "```"))
    elif doc.silent:
        yield LOG_LINES, f"None: {doc.silent}."
    if references:
        yield HEADINGS[-1], references


def _lines(text: str) -> Iterator[tuple[str, bool]]:
    """Each line, and whether it lies in a code block; the fences do not."""
    fence = ""
    for line in text.splitlines():
        marker = re.match(r" *(`{3,}|~{3,})", line)
        if marker and (not fence or marker[1].startswith(fence)):
            fence = "" if fence else marker[1]
            yield line, False
        else:
            yield line, bool(fence)


def _set(body: str, width: int, paint: Paint) -> Iterator[str]:
    """A section as lines for a terminal."""
    paragraph: list[str] = []
    for line, code in _lines(body):
        fence = not code and re.match(r" *(```|~~~)", line)
        if code or fence or not line.strip() or re.match(r" *([-*]|\d+\.) |\|", line):
            yield from _prose(paragraph, width, paint)
            paragraph = []
        if code:
            yield f"    {paint('code', line)}".rstrip()
        elif not line.strip():
            yield ""
        elif not fence:
            paragraph.append(line)
    yield from _prose(paragraph, width, paint)


def _prose(paragraph: list[str], width: int, paint: Paint) -> Iterator[str]:
    if not paragraph:
        return
    indent = " " * (len(paragraph[0]) - len(paragraph[0].lstrip(" ")))
    text = indent + _without_links(" ".join(line.strip() for line in paragraph))
    lines = "\n".join(wrap(text, width - 2))
    lines = re.sub(r"\*\*(.+?)\*\*", lambda bold: _each(bold[1], "strong", paint), lines, flags=re.DOTALL)
    if paint("code", "`") != "`":
        lines = re.sub(r"`([^`]+)`", lambda word: _each(word[1], "code", paint), lines)
    yield from (f"  {line}" for line in lines.splitlines())


def _each(text: str, style: str, paint: Paint) -> str:
    return "\n".join(paint(style, line) for line in text.split("\n"))


def _without_links(text: str) -> str:
    return re.sub(r"(?<!`)\[([^\]]+)\]\((https?://[^)\s]+)\)", r"\1 (\2)", text)
