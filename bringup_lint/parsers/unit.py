"""Unit files and drop-ins: the line grammar of systemd.syntax(7).

Per the systemd source (``src/shared/conf-parser.c``): a comment is a line whose first non-blank character is ``#`` or
``;``, also between continued lines; an unescaped backslash before the line end becomes a blank and joins the next
line without its leading blanks; a blank line ends a continuation. A file with a line of more than LONG_LINE_MAX
bytes, continued lines joined, is not loaded.
"""

from __future__ import annotations

import re
from collections.abc import Iterator

from bringup_lint.model.unit import Assignment
from bringup_lint.model.unit import Section
from bringup_lint.model.unit import UnitFile
from bringup_lint.pattern import regex
from bringup_lint.source import Located
from bringup_lint.source import Problem
from bringup_lint.source import Source
from bringup_lint.templates import final_name
from bringup_lint.templates import has_control_flow
from bringup_lint.templates import has_placeholder
from bringup_lint.templates import is_to_fill

_LINE = regex(r"([^\r\n]*)(?:\r\n|[\r\n]|\Z)")
_OF_PATHS = regex(r"Exec\w+|WorkingDirectory|RootDirectory|EnvironmentFile|PIDFile|User|Group")
"""Settings whose values are no words in capitals, unless a script replaces these."""
_FILLED = ("configure", "template")
"""Languages that may have variables of a shell for placeholders."""
_VARIABLE = regex(r"\$\{?[A-Z_][A-Z0-9_]*\b")
_FILLED_ELSEWHERE = regex(r"^(?!Exec)\w+[ \t]*=[^\n$]*\$\{?[A-Z_][A-Z0-9_]*\b", re.M)
"""A variable where systemd expands none: something else does, before it."""
_BLANK = " \t\n\r"
LONGEST = 1024 * 1024
"""Bytes of a line (LONG_LINE_MAX)."""
TOO_LONG = "line-too-long"
_SHOWN = 20
"""Characters of such a line."""
_TEMPLATE_LINE = regex(r"\{%.*%\}|\{#.*#\}|@\[.*\]|(?:m4_)?(?:ifdef|ifelse|dnl|divert)\b|<%|#(?:if|else|endif)\b")


def parse(source: Source) -> UnitFile:
    """Read a unit file or drop-in. Never raises; what systemd would drop is in ``problems``: ``bad-section-header``,
    ``line-outside-section``, ``missing-equals``, ``continuation-at-end``, ``backslash-blank``; and ``line-too-long``,
    for which it drops the whole file.

    In a template, a line without ``=`` is a macro that may open another section: what follows it belongs to none."""
    unit = UnitFile(source, *unit_name(source))
    unit.uncertain = bool(source.template) and has_control_flow(source.text)
    endless = _endless_line(source) if len(source.text) > LONGEST else None
    if endless is not None:
        unit.problems.append(Problem(TOO_LONG, endless))
        unit.uncertain = True
        return unit
    section: Section | None = None
    broken_header = False
    for line in logical_lines(source, unit.problems):
        text = line.strip_located(_BLANK)
        if not text or (source.template and _TEMPLATE_LINE.match(text)):
            continue
        if text[0] == "[":
            section = _section(text, unit)
            broken_header = broken_header or section is None
            continue
        if source.template and "=" not in text:
            section, unit.uncertain = None, True
            continue
        if section is not None:
            _assignment(text, section, unit)
        elif not broken_header:
            unit.problems.append(Problem("line-outside-section", text))
    return unit


def _endless_line(source: Source) -> Located | None:
    """The start of the first line that is so long that systemd does not load the file."""
    lines = (line for line in logical_lines(source, []) if len(line.encode("utf-8", "replace")) > LONGEST)
    return next((line.part(0, _SHOWN) for line in lines), None)


def logical_lines(source: Source, problems: list[Problem]) -> Iterator[Located]:
    """The lines as systemd sees them: comments gone, continued lines joined."""
    pieces: list[tuple[int, int]] = []
    joined: list[str] = []
    length = 0
    for start, end in _physical_lines(source.text):
        line = source.text[start:end]
        content = line.lstrip(_BLANK)
        if content[:1] in ("#", ";"):
            continue
        if not joined and "\\" not in line:
            yield source.located(start, end)
            continue
        if joined:
            start += len(line) - len(content)
            line = content
        continued = _ends_with_backslash(line)
        if not continued and line.rstrip(_BLANK).endswith("\\") and line[-1:] in (" ", "\t"):
            at = start + len(line.rstrip(_BLANK)) - 1
            problems.append(Problem("backslash-blank", source.span(at, end)))
        pieces.append((length, start))
        joined.append(line[:-1] + " " if continued else line)
        length += len(line)
        if continued:
            backslash = end - 1
            continue
        if len(joined) > 1 and not content:
            problems.append(Problem("continuation-at-end", source.span(backslash, backslash + 1)))
        yield _joined(source, joined, pieces, end)
        joined, pieces, length = [], [], 0
    if joined:
        problems.append(Problem("continuation-at-end", source.span(backslash, backslash + 1)))
        yield _joined(source, joined, pieces, len(source.text))


def _joined(source: Source, lines: list[str], pieces: list[tuple[int, int]], end: int) -> Located:
    span = source.span(pieces[0][1], end)
    return Located("".join(lines), span, tuple(pieces) if len(pieces) > 1 else None)


def _physical_lines(text: str) -> Iterator[tuple[int, int]]:
    for line in _LINE.finditer(text, 1 if text.startswith("\ufeff") else 0):
        if line.start() < len(text):
            yield line.span(1)


def _ends_with_backslash(line: str) -> bool:
    return line.endswith("\\") and (len(line) - len(line.rstrip("\\"))) % 2 == 1


def _section(text: Located, unit: UnitFile) -> Section | None:
    if text[-1] != "]":
        unit.problems.append(Problem("bad-section-header", text))
        return None
    section = Section(text.part(1, len(text) - 1), text.span, [])
    unit.sections.append(section)
    return section


def _assignment(text: Located, section: Section, unit: UnitFile) -> None:
    key, equals, _ = text.partition("=")
    if not equals:
        unit.problems.append(Problem("missing-equals", text))
        return
    value = text.part(len(key) + 1, len(text)).strip_located(_BLANK)
    name = text.part(0, len(key)).strip_located(_BLANK)
    opaque = (bool(unit.source.template) and _is_filled(unit.source, value)) or (
        is_to_fill(value) and bool(_OF_PATHS.fullmatch(name))
    )
    section.assignments.append(Assignment(section.name, name, value, text.span, opaque))


def _is_filled(source: Source, value: str) -> bool:
    """Whether a value of a template still holds a placeholder."""
    if has_placeholder(value):
        return True
    return source.template in _FILLED and bool(_VARIABLE.search(value)) and source.matches(_FILLED_ELSEWHERE)


def unit_name(source: Source) -> tuple[str, bool]:
    """The unit that a file describes, and whether the file is a drop-in of it. A service kept under the name
    ``robot.conf`` is installed as ``robot.service``; a file that is installed under another name has that one."""
    *_, folder, name = ("", "", *(source.robot_path or source.name).split("/"))
    if folder.endswith(".d") and source.kind == "systemd-dropin":
        return folder[:-2], True
    name = final_name(name)
    return (f"{name[:-5]}.service" if name.endswith(".conf") else name), False
