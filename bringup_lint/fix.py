"""Applies fixes to files: whole fixes only, never two that touch each other. A file that cannot be written costs its
own fixes."""

from __future__ import annotations

import os
import re
from collections.abc import Iterable
from itertools import pairwise
from pathlib import Path

from bringup_lint.dataclass import dataclass
from bringup_lint.dataclass import field
from bringup_lint.dataclass import replace
from bringup_lint.finding import Applicability
from bringup_lint.finding import Codemod
from bringup_lint.finding import Edit
from bringup_lint.finding import Finding
from bringup_lint.finding import Fix
from bringup_lint.model.python import syntax_of
from bringup_lint.named_tuple import NamedTuple
from bringup_lint.pattern import regex
from bringup_lint.source import Source
from bringup_lint.writing import NotWritten
from bringup_lint.writing import correct

TOUCHES = "another fix changes the same place"
NOT_VALID = "the file would not be valid"
_LONE_CR = regex(r"\r(?!\n)")


@dataclass
class Changes:
    """What shall be done to one file: edits that do not touch each other, or the one text that a codemod made."""

    source: Source
    edits: list[Edit] = field(default_factory=list)
    text: str | None = None

    def new_text(self) -> str:
        return rewritten(self.source.text, self.edits) if self.text is None else self.text


@dataclass
class Proposal:
    """Rounds of fixes that write nothing."""

    before: dict[str, Source] = field(default_factory=dict)
    """The files that would change, by name, as they are."""
    texts: dict[str, bytes] = field(default_factory=dict)
    """What they would hold, by absolute path."""

    def apply(self, findings: Iterable[Finding], *, unsafe: bool = False) -> Fixed:
        plan = planned(findings, unsafe=unsafe)
        for change in plan.changes.values():
            self.before.setdefault(change.source.name, change.source)
            self._hold(change.source, change.new_text())
        return Fixed(tuple(finding for finding, _ in plan.taken), (), tuple(plan.changes.values()))

    def take_back(self, written: Iterable[Changes]) -> tuple[NotWritten, ...]:
        for change in written:
            self._hold(change.source, change.source.text)
        return ()

    def _hold(self, source: Source, text: str) -> None:
        self.texts[os.path.abspath(source.name)] = text.encode("utf-8")


class Plan(NamedTuple):
    """What fixes would do to the files."""

    changes: dict[str, Changes]
    """By the name of the file."""
    taken: tuple[tuple[Finding, frozenset[str]], ...]
    """The findings that would be fixed, with the names of the files of their edits."""
    left: tuple[tuple[Finding, str], ...]
    """The findings with a fix that would not be applied, and why."""


class Fixed(NamedTuple):
    """What a round of fixes has done."""

    findings: tuple[Finding, ...] = ()
    failures: tuple[NotWritten, ...] = ()
    """Why files were not written."""
    written: tuple[Changes, ...] = ()


def planned(findings: Iterable[Finding], *, unsafe: bool = False) -> Plan:
    """Take up what can be applied together, and leave alone the files that could not be read afterwards."""
    found = [each for finding in findings for each in (finding, *finding.copies)]
    broken: set[str] = set()
    while True:
        plan = _plan(found, unsafe, broken)
        more = {name for name, change in plan.changes.items() if not _stays_well_formed(change)}
        if not more:
            return plan
        broken |= more


def _plan(findings: Iterable[Finding], unsafe: bool, broken: set[str]) -> Plan:
    """What can be applied together, outside of the files that it would break."""
    changes: dict[str, Changes] = {}
    taken, left = [], []
    for finding in findings:
        fix = finding.fix
        if fix is None or finding.suppression:
            continue
        why = _obstacle(fix, unsafe) or _breaks(fix, broken) or _taken_up(fix, changes)
        if why:
            left.append((finding, why))
        else:
            taken.append((finding, _files_of(fix)))
    return Plan(changes, tuple(taken), tuple(left))


def _breaks(fix: Fix, broken: set[str]) -> str:
    return "" if broken.isdisjoint(_files_of(fix)) else NOT_VALID


def _stays_well_formed(change: Changes) -> bool:
    """Whether a file that could be read before its changes can be read after them."""
    from bringup_lint.parsers.well_formed import is_well_formed

    after = replace(change.source, text=change.new_text())
    return is_well_formed(after) or not is_well_formed(change.source)


def apply_fixes(findings: Iterable[Finding], *, unsafe: bool = False) -> Fixed:
    """Apply what can be applied together. A file that cannot be written is left as it is."""
    plan = planned(findings, unsafe=unsafe)
    failures = {name: failure for name, change in plan.changes.items() if (failure := _failure(change))}
    fixed = tuple(finding for finding, names in plan.taken if failures.keys().isdisjoint(names))
    written = tuple(change for name, change in plan.changes.items() if name not in failures)
    return Fixed(fixed, tuple(failures.values()), written)


def save(changes: Iterable[Changes]) -> tuple[NotWritten, ...]:
    """Write changes that are no fixes; why some could not be."""
    return tuple(failure for change in changes if (failure := _failure(change)))


def taken_back(written: Iterable[Changes]) -> tuple[NotWritten, ...]:
    """Write the texts of before a round; why some could not be."""
    back = (Changes(replace(change.source, text=change.new_text()), text=change.source.text) for change in written)
    return save(back)


def _files_of(fix: Fix) -> frozenset[str]:
    return frozenset({fix.codemod.source.name} if fix.codemod else {edit.span.path for edit in fix.edits})


def _obstacle(fix: Fix, unsafe: bool) -> str:
    """Why a fix cannot be applied, whatever else is; empty when it can."""
    if fix.applicability is Applicability.UNSAFE and not unsafe:
        return "unsafe: --unsafe-fixes"
    sources = [fix.codemod.source] if fix.codemod else [edit.span.source for edit in fix.edits]
    if not all(map(writable, sources)):
        return "its file is a link, not UTF-8, or ends its lines with CR alone"
    in_order = sorted(fix.edits, key=lambda edit: (edit.span.path, edit.span.start, edit.span.end))
    pairs = pairwise(in_order)
    if any(one.span.path == other.span.path and one.span.end > other.span.start for one, other in pairs):
        return "its edits overlap"
    return ""


def _taken_up(fix: Fix, changes: dict[str, Changes]) -> str:
    """Take up a fix; why it cannot be, or an empty text."""
    if fix.codemod:
        if fix.codemod.source.name in changes:
            return TOUCHES
        return "" if _rewrite(fix.codemod, changes) else NOT_VALID
    return "" if _edit(fix.edits, changes) else TOUCHES


def _failure(change: Changes) -> NotWritten | None:
    """Write the changes of a file; why that could not be done, or None."""
    try:
        correct(Path(change.source.name), change.source.text.encode("utf-8"), change.new_text().encode("utf-8"))
    except NotWritten as error:
        return error
    return None


def _edit(edits: tuple[Edit, ...], changes: dict[str, Changes]) -> bool:
    """Take up the edits of a fix; False when one of them cannot be made together with what is there."""
    if not edits or not all(_fits(edit, changes.get(edit.span.path)) for edit in edits):
        return False
    for edit in edits:
        changes.setdefault(edit.span.path, Changes(edit.span.source)).edits.append(edit)
    return True


def _rewrite(codemod: Codemod, changes: dict[str, Changes]) -> bool:
    """Take up a codemod, alone in its file; False when it changes nothing, or makes a file that is not valid."""
    source = codemod.source
    text = codemod.change(source.text)
    if text == source.text:
        return False
    if syntax_of(text.removeprefix("\ufeff")) is None:
        return False
    changes[source.name] = Changes(source, text=text)
    return True


def writable(source: Source) -> bool:
    """Whether a text can be written back as it was read, but for the edits."""
    linked = source.link is not None or os.path.islink(source.name)
    return source.judged and not linked and "\ufffd" not in source.text and not _LONE_CR.search(source.text)


def _fits(edit: Edit, change: Changes | None) -> bool:
    if change is not None and change.text is not None:
        return False
    taken = change.edits if change is not None else []
    return all(edit.span.end < other.span.start or other.span.end < edit.span.start for other in taken)


def rewritten(text: str, edits: Iterable[Edit]) -> str:
    """The text with its edits, which do not overlap: with the line ends of the file, below its byte order mark."""
    crlf = text.count("\r\n") * 2 > text.count("\n")
    first = len(text) - len(text.removeprefix("\ufeff"))
    for edit in sorted(edits, key=lambda edit: (edit.span.start, edit.span.end), reverse=True):
        new = re.sub(r"\r?\n", "\r\n", edit.text) if crlf else edit.text
        start = max(edit.span.start, first)
        text = text[:start] + new.removeprefix("\ufeff") + text[max(edit.span.end, start) :]
    return text
