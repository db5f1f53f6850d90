"""Applies fixes to files: whole fixes only, never two that touch each other, never through a link."""

from __future__ import annotations

import os
from collections.abc import Iterable
from pathlib import Path

from bringup_lint.finding import Applicability
from bringup_lint.finding import Edit
from bringup_lint.finding import Finding
from bringup_lint.source import Source


def apply_fixes(findings: Iterable[Finding], *, unsafe: bool = False) -> int:
    """Apply what can be applied together; returns the number of findings that were fixed. Raises OSError."""
    edits: dict[str, tuple[Source, list[Edit]]] = {}
    fixed = 0
    for finding in findings:
        fix = finding.fix
        if fix is None or finding.suppression or (fix.applicability is Applicability.UNSAFE and not unsafe):
            continue
        if not fix.edits or not all(_fits(edit, edits) for edit in fix.edits):
            continue
        for edit in fix.edits:
            edits.setdefault(edit.span.path, (edit.span.source, []))[1].append(edit)
        fixed += 1
    for source, changes in edits.values():
        _write(Path(source.name), rewritten(source.text, changes))
    return fixed


def _fits(edit: Edit, edits: dict[str, tuple[Source, list[Edit]]]) -> bool:
    source = edit.span.source
    if not source.judged or source.link is not None or os.path.islink(source.name) or "\ufffd" in source.text:
        return False
    _, taken = edits.get(source.name, (source, []))
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
