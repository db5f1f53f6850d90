"""One finding for what a rule says twice of one file, and for a line that a tree holds twice: in a template and in what
was made of it, in a file and its copy under another name, or in two udev rules files of one name, of which only one is
read on a robot."""

from __future__ import annotations

from collections.abc import Hashable
from collections.abc import Iterable
from collections.abc import Iterator

from bringup_lint.dataclass import replace
from bringup_lint.finding import Finding
from bringup_lint.finding import Related
from bringup_lint.pattern import regex
from bringup_lint.source import Source
from bringup_lint.templates import final_name

REPEATED = "the same here"
"""What is said of a place in the same file."""
COPIED = "the same line in a copy"
_MADE = regex(r"(?:^|/)(?:deploy|dist|out|output|build|install|generated|release)/")
"""Folders for what is made of other files."""


def merged(findings: Iterable[Finding]) -> Iterator[Finding]:
    """The findings in their order, those that say the same of one file or are on a copy of a line as related places of
    the first."""
    return _copied(_repeated(findings))


def _repeated(findings: Iterable[Finding]) -> list[Finding]:
    """The findings; of those in one file that are alike in all but their place, the first with the others."""
    groups: dict[Hashable, list[Finding]] = {}
    for found in findings:
        alike = (found.rule, found.source, found.severity, found.message, found.confidence)
        key = id(found) if found.suppression or not found.span.end else alike
        groups.setdefault(key, []).append(found)
    return [_with(first, others, REPEATED) for first, *others in groups.values()]


def _copied(ordered: list[Finding]) -> Iterator[Finding]:
    """The findings, those on a copy of a line with the first of them."""
    groups: dict[tuple[str, str, str], list[Finding]] = {}
    lines: dict[tuple[Source, int], str] = {}
    for found in ordered:
        if found.span.end and not found.suppression:
            groups.setdefault((found.rule, _line(found, lines), found.span.text), []).append(found)
    copies: dict[int, list[Finding]] = {}
    gone: set[int] = set()
    for group in groups.values():
        if len({found.source for found in group}) == 1:
            continue
        kept: dict[Hashable, dict[str, tuple[int, Finding]]] = {}
        """Of what files of one name have in common with their copies, the first that has it."""
        for number, found in enumerate(sorted(group, key=_rank)):
            keys = _alike(found.source, named=not found.source.template)
            alike = dict(pair for key in keys for pair in kept.get(key, {}).values())
            first = min((at for at, one in alike.items() if _is_copy(found, one)), default=None)
            if first is None:
                for key in _alike(found.source, named=bool(found.source.template)):
                    kept.setdefault(key, {}).setdefault(found.source.basename, (number, found))
            else:
                copies.setdefault(id(alike[first]), []).append(found)
                gone.add(id(found))
    for found in ordered:
        if id(found) not in gone:
            yield _with(found, copies.get(id(found), []), COPIED)


def _with(found: Finding, copies: list[Finding], words: str) -> Finding:
    if not copies:
        return found
    every = [each for copy in copies for each in (copy, *copy.copies)]
    related = [Related(each.span, words) for each in every]
    return replace(found, related=(*found.related, *related), copies=(*found.copies, *every))


def _line(found: Finding, lines: dict[tuple[Source, int], str]) -> str:
    """The line of a finding, read once for all that it has."""
    place = (found.source, found.span.line)
    if place not in lines:
        lines[place] = found.source.line_text(found.span.line).strip()
    return lines[place]


def _rank(found: Finding) -> tuple[int, bool, bool, int]:
    """The worst comes first. A template is the original, and what lies in a folder of results is none; of others, what
    lies in the fewest folders is."""
    name = found.source.name
    return -found.severity, not found.source.template, bool(_MADE.search(name)), name.count("/")


def _alike(source: Source, *, named: bool) -> Iterator[Hashable]:
    """What a file has in common with its copies: the text, the name of udev rules, and, where it is ``named`` for it,
    what a template makes."""
    yield source.kind, source.text
    if source.kind == "udev-rules":
        yield "rules", source.basename
    if named:
        yield "made", final_name(source.basename)


def _is_copy(found: Finding, kept: Finding) -> bool:
    """Whether one file is a copy of the other. Files of one name are of several robots or packages, each of which may
    come and go by itself; of udev rules, one is read."""
    copy, first = found.source, kept.source
    if copy is first:
        return False
    if copy.basename == first.basename:
        return copy.kind == first.kind == "udev-rules"
    if final_name(copy.basename) == final_name(first.basename):
        return bool(first.template) and not copy.template
    return copy.kind == first.kind and found.advice == kept.advice and copy.text == first.text
