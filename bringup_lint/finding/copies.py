"""One finding for a line that a tree holds twice: in a template and in what was made of it, or in two udev rules files
of one name, of which only one is read on a robot."""

from __future__ import annotations

from collections.abc import Iterable
from collections.abc import Iterator
from dataclasses import replace
from typing import NamedTuple

from bringup_lint.finding import Finding
from bringup_lint.finding import Related
from bringup_lint.source import Source
from bringup_lint.templates import final_name


class Line(NamedTuple):
    """What two findings on copies of one line have in common."""

    rule: str
    file: str
    """The name of the file, once it is filled in."""
    text: str
    found: str
    """The text of the place itself."""


def merged(findings: Iterable[Finding]) -> Iterator[Finding]:
    """The findings in their order, those on a copy of a line as related places of the first.

    A template is the first, wherever it lies: what is made of it is made again.
    """
    groups: dict[Line, list[Finding]] = {}
    ordered = list(findings)
    for found in ordered:
        groups.setdefault(_line(found), []).append(found)
    first: dict[int, Finding] = {}
    gone: set[int] = set()
    for group in groups.values():
        kept = min(group, key=lambda found: not found.source.template)
        copies = [found for found in group if _is_copy(found, kept)]
        gone.update(map(id, copies))
        if copies:
            related = [Related(found.span, "the same line in a copy") for found in copies]
            first[id(kept)] = replace(kept, related=(*kept.related, *related))
    for found in ordered:
        if id(found) not in gone:
            yield first.get(id(found), found)


def _line(found: Finding) -> Line:
    source, span = found.source, found.span
    text = source.line_text(span.line).strip() if span.end else ""
    return Line(found.rule, final_name(source.basename), text, span.text)


def _is_copy(found: Finding, kept: Finding) -> bool:
    if found is kept or found.source is kept.source or found.suppression or kept.suppression or not found.span.text:
        return False
    return _is_made_of(found.source, kept.source) or found.source.kind == kept.source.kind == "udev-rules"


def _is_made_of(source: Source, template: Source) -> bool:
    return bool(template.template) and not source.template and source.basename != template.basename
