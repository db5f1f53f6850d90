"""Applies fixes to files: whole fixes only, never two that touch each other. A file that cannot be written costs its
own fixes."""

from __future__ import annotations

import os
import re
from collections import Counter
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
MOST_HELD_BACK = 8
"""So many fixes that break a file are left out one by one; where there are more, the file is left as it is."""
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

    def apply(self, plan: Plan) -> Fixed:
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
    """Take up what can be applied together, but for fixes after which a file could not be read."""
    guard = _Guard()
    found = [each for finding in findings for each in (finding, *finding.copies)]
    while True:
        plan = _plan(found, unsafe, guard)
        broken = [change for change in plan.changes.values() if not guard.stays_well_formed(change)]
        if not broken:
            return plan
        for change in broken:
            guard.hold_back(change, plan)


@dataclass
class _Guard:
    """What is held back because a file could not be read afterwards."""

    fixes: set[int] = field(default_factory=set)
    """The findings whose fix breaks a file, by identity."""
    files: set[str] = field(default_factory=set)
    """The files with too many of them."""
    tried: Counter[str] = field(default_factory=Counter)
    known: dict[str, tuple[str, bool]] = field(default_factory=dict)
    """File -> the last text that was asked for, and whether it can be read."""

    def objection(self, finding: Finding, fix: Fix) -> str:
        is_held = id(finding) in self.fixes or not self.files.isdisjoint(_files_of(fix))
        return NOT_VALID if is_held else ""

    def stays_well_formed(self, change: Changes) -> bool:
        """Whether a file that could be read before its changes can be read after them."""
        text, name = change.new_text(), change.source.name
        if self.known.get(name, ("",))[0] != text:
            self.known[name] = (text, _is_readable(change.source, text) or not _is_readable(change.source))
        return self.known[name][1]

    def hold_back(self, change: Changes, plan: Plan) -> None:
        """Hold back the first fix that breaks a file; all of them in a file that many break."""
        name = change.source.name
        self.tried[name] += 1
        if self.tried[name] > MOST_HELD_BACK:
            self.files.add(name)
        else:
            self.fixes.add(id(_first_to_break(change, [each for each, names in plan.taken if name in names])))


def _first_to_break(change: Changes, findings: list[Finding]) -> Finding:
    """The finding with whose fix a file cannot be read any more, of findings in the order in which they are fixed."""
    name, whole, broken = change.source.name, 0, len(findings)
    while broken - whole > 1:
        middle = (whole + broken) // 2
        if _is_readable(change.source, rewritten(change.source.text, _edits_of(findings[:middle], name))):
            whole = middle
        else:
            broken = middle
    return findings[whole]


def _edits_of(findings: Iterable[Finding], name: str) -> list[Edit]:
    """The edits that findings have for a file."""
    return [edit for finding in findings if finding.fix for edit in finding.fix.edits if edit.span.path == name]


def _is_readable(source: Source, text: str | None = None) -> bool:
    """Whether a file can be read, with a text in place of its own where one is given."""
    from bringup_lint.parsers.well_formed import is_well_formed

    return is_well_formed(source if text is None else replace(source, text=text))


def _plan(findings: Iterable[Finding], unsafe: bool, guard: _Guard) -> Plan:
    """What can be applied together, without what the guard holds back."""
    changes: dict[str, Changes] = {}
    taken, left = [], []
    for finding in findings:
        fix = finding.fix
        if fix is None or finding.suppression:
            continue
        why = _obstacle(fix, unsafe) or guard.objection(finding, fix) or _taken_up(fix, changes)
        if why:
            left.append((finding, why))
        else:
            taken.append((finding, _files_of(fix)))
    return Plan(changes, tuple(taken), tuple(left))


def apply_fixes(plan: Plan) -> Fixed:
    """Do what is planned. A file that cannot be written is left as it is."""
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
