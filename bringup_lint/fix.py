"""Applies fixes to files: whole fixes only, never two that touch each other. A file that cannot be written costs its
own fixes."""

from __future__ import annotations

import ast
import os
from collections.abc import Iterable
from dataclasses import dataclass
from dataclasses import field
from pathlib import Path
from typing import NamedTuple

from bringup_lint.finding import Applicability
from bringup_lint.finding import Codemod
from bringup_lint.finding import Edit
from bringup_lint.finding import Finding
from bringup_lint.source import Source
from bringup_lint.writing import NotWritten
from bringup_lint.writing import correct


@dataclass
class _Changes:
    """What shall be done to one file: edits that do not touch each other, or the one text that a codemod made."""

    source: Source
    edits: list[Edit] = field(default_factory=list)
    text: str | None = None

    def content(self) -> bytes:
        text = rewritten(self.source.text, self.edits) if self.text is None else self.text
        return text.encode("utf-8")


class Fixed(NamedTuple):
    """What a round of fixes has done."""

    findings: int
    failures: tuple[NotWritten, ...] = ()
    """Why files were not written."""


def apply_fixes(findings: Iterable[Finding], *, unsafe: bool = False) -> Fixed:
    """Apply what can be applied together. A file that cannot be written is left as it is."""
    changes: dict[str, _Changes] = {}
    taken: list[set[str]] = []
    for finding in findings:
        fix = finding.fix
        if fix is None or finding.suppression or (fix.applicability is Applicability.UNSAFE and not unsafe):
            continue
        if _rewrite(fix.codemod, changes) if fix.codemod else _edit(fix.edits, changes):
            taken.append({fix.codemod.source.name} if fix.codemod else {edit.span.path for edit in fix.edits})
    failures = {name: failure for name, change in changes.items() if (failure := _failure(change))}
    return Fixed(sum(failures.keys().isdisjoint(names) for names in taken), tuple(failures.values()))


def _failure(change: _Changes) -> NotWritten | None:
    """Write the changes of a file; why that could not be done, or None."""
    try:
        correct(Path(change.source.name), change.source.text.encode("utf-8"), change.content())
    except NotWritten as error:
        return error
    return None


def _edit(edits: tuple[Edit, ...], changes: dict[str, _Changes]) -> bool:
    """Take up the edits of a fix; False when one of them cannot be made together with what is there."""
    if not edits or not all(_fits(edit, changes.get(edit.span.path)) for edit in edits):
        return False
    for edit in edits:
        changes.setdefault(edit.span.path, _Changes(edit.span.source)).edits.append(edit)
    return True


def _rewrite(codemod: Codemod, changes: dict[str, _Changes]) -> bool:
    """Take up a codemod, alone in its file; False when it changes nothing, or makes no valid file."""
    source = codemod.source
    if source.name in changes or not _writable(source):
        return False
    text = codemod.change(source.text)
    if text == source.text:
        return False
    try:
        ast.parse(text.removeprefix("\ufeff"))
    except (SyntaxError, ValueError, RecursionError):
        return False
    changes[source.name] = _Changes(source, text=text)
    return True


def _writable(source: Source) -> bool:
    linked = source.link is not None or os.path.islink(source.name)
    return source.judged and not linked and "\ufffd" not in source.text


def _fits(edit: Edit, change: _Changes | None) -> bool:
    if not _writable(edit.span.source) or (change is not None and change.text is not None):
        return False
    taken = change.edits if change is not None else []
    return all(edit.span.end < other.span.start or other.span.end < edit.span.start for other in taken)


def rewritten(text: str, edits: Iterable[Edit]) -> str:
    """The text with its edits, which do not overlap."""
    for edit in sorted(edits, key=lambda edit: edit.span.start, reverse=True):
        text = text[: edit.span.start] + edit.text + text[edit.span.end :]
    return text
