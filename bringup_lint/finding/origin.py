"""Findings about a file that another file writes are shown in the file that writes it."""

from __future__ import annotations

from bringup_lint.dataclass import replace
from bringup_lint.finding import Confidence
from bringup_lint.finding import Edit
from bringup_lint.finding import Finding
from bringup_lint.finding import Fix
from bringup_lint.finding import Related
from bringup_lint.source import Span

_EXPANDED = "$`\\"
"""What a shell would expand in an edit."""


def at_origin(finding: Finding) -> Finding:
    """The finding, with every place where the tree holds it."""
    spans = [finding.span, *finding.hidden]
    spans += [each.span for each in (*finding.related, *finding.chain)]
    if all(span.source.origin is None for span in spans):
        return finding
    origin = finding.span.source.origin
    return replace(
        finding,
        span=_shown(finding.span),
        related=tuple(Related(_shown(each.span), each.message) for each in finding.related),
        chain=tuple(Related(_shown(each.span), each.message) for each in finding.chain),
        hidden=tuple(map(_shown, finding.hidden)),
        secrets=tuple(map(_shown, finding.secrets)),
        fix=_fix(finding.fix),
        own_confidence=finding.own_confidence if origin is None or origin.certain else Confidence.MEDIUM,
    )


def _shown(span: Span) -> Span:
    origin = span.source.origin
    return span if origin is None else origin.span(span.start, span.end)


def _fix(fix: Fix | None) -> Fix | None:
    """The same edits in the file that writes, where its text is the same."""
    if fix is None or fix.codemod is not None:
        return fix
    if not all(_holds(edit) for edit in fix.edits):
        return None
    return replace(fix, edits=tuple(Edit(_shown(edit.span), edit.text) for edit in fix.edits))


def _holds(edit: Edit) -> bool:
    origin = edit.span.source.origin
    if origin is None:
        return True
    same = _shown(edit.span).text == edit.span.text
    return origin.verbatim and same and not any(mark in edit.text for mark in _EXPANDED)
