"""Applies fixes to files: whole fixes only, never two that touch each other, never through a link."""

from __future__ import annotations

import ast
import os
from collections.abc import Iterable
from dataclasses import dataclass
from dataclasses import field
from pathlib import Path

from bringup_lint.finding import Applicability
from bringup_lint.finding import Codemod
from bringup_lint.finding import Edit
from bringup_lint.finding import Finding
from bringup_lint.source import Source


@dataclass
class _Changes:
    """What shall be done to one file: edits that do not touch each other, or the one text that a codemod made."""

    source: Source
    edits: list[Edit] = field(default_factory=list)
    text: str | None = None


def apply_fixes(findings: Iterable[Finding], *, unsafe: bool = False) -> int:
    """Apply what can be applied together; returns the number of findings that were fixed. Raises OSError."""
    changes: dict[str, _Changes] = {}
    fixed = 0
    for finding in findings:
        fix = finding.fix
        if fix is None or finding.suppression or (fix.applicability is Applicability.UNSAFE and not unsafe):
            continue
        fixed += _rewrite(fix.codemod, changes) if fix.codemod else _edit(fix.edits, changes)
    for change in changes.values():
        text = rewritten(change.source.text, change.edits) if change.text is None else change.text
        _write(Path(change.source.name), text)
    return fixed


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


def _write(path: Path, text: str) -> None:
    """Replace a file whole, keeping its mode."""
    temporary = path.with_name(f".{path.name}.bringup-lint")
    temporary.write_bytes(text.encode("utf-8"))
    temporary.chmod(path.stat().st_mode & 0o7777)
    temporary.replace(path)
