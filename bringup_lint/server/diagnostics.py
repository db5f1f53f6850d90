"""Findings as diagnostics."""

from __future__ import annotations

from lsprotocol.types import CodeDescription
from lsprotocol.types import Diagnostic
from lsprotocol.types import DiagnosticRelatedInformation
from lsprotocol.types import DiagnosticSeverity
from lsprotocol.types import DiagnosticTag
from lsprotocol.types import Location

from bringup_lint.finding import Severity
from bringup_lint.registry import doc_of
from bringup_lint.server.analysis import Analysis
from bringup_lint.server.analysis import Found
from bringup_lint.source import Span

SOURCE = "bringup-lint"
_SEVERITIES = {
    Severity.ERROR: DiagnosticSeverity.Error,
    Severity.WARNING: DiagnosticSeverity.Warning,
    Severity.INFO: DiagnosticSeverity.Information,
}
_TAGS = {"deprecated": DiagnosticTag.Deprecated, "unnecessary": DiagnosticTag.Unnecessary}


def diagnostics(analysis: Analysis, path: str) -> list[Diagnostic]:
    """What was found in a file."""
    return [diagnostic(analysis, each) for each in analysis.by_path.get(path, ())]


def diagnostic(analysis: Analysis, found: Found) -> Diagnostic:
    finding, shown = found
    rule = analysis.rules.get(finding.rule)
    uri = doc_of(rule).uri if rule else ""
    own = rule.meta.tags if rule else ()
    tags = [_TAGS[tag] for tag in own if tag in _TAGS]
    others = zip((*finding.related, *finding.chain), (*shown.related, *shown.chain))
    return Diagnostic(
        range=analysis.range(finding.span),
        message=f"{shown.message}\n{shown.advice}" if shown.advice else shown.message,
        severity=_SEVERITIES[finding.severity],
        code=finding.rule,
        code_description=CodeDescription(uri) if uri else None,
        source=SOURCE,
        tags=tags or None,
        related_information=[
            DiagnosticRelatedInformation(location(analysis, other.span), words.message) for other, words in others
        ]
        or None,
        data=shown.fingerprint,
    )


def location(analysis: Analysis, span: Span) -> Location:
    return Location(analysis.uri(span.source), analysis.range(span))
