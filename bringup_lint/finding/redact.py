"""Masks secrets: what a finding marks as secret, or a file shows by its name to be one, no report prints."""

from __future__ import annotations

import re
from collections import defaultdict
from collections.abc import Iterable
from functools import cached_property

from bringup_lint.dataclass import replace
from bringup_lint.finding import Edit
from bringup_lint.finding import Finding
from bringup_lint.finding import Fix
from bringup_lint.finding import Related
from bringup_lint.finding.place import inside
from bringup_lint.finding.secrets import MERE_NAME
from bringup_lint.finding.secrets import given_away
from bringup_lint.pattern import regex
from bringup_lint.source import Source
from bringup_lint.source import Span

SHORTEST = 6
"""A secret of fewer characters is masked where it is marked, not in every text that happens to hold it."""


_WORD = regex(r"[A-Za-z]{1,11}")


def mask_of(findings: Iterable[Finding], sources: Iterable[Source] = ()) -> Mask | None:
    """The mask for the secrets of these findings, the files they show and these files; None when there are none."""
    findings = tuple(findings)
    marked = (inside(span) for finding in findings for span in finding.secrets)
    shown = _shown(findings) | dict.fromkeys(sources)
    named = (span for source in shown for span in given_away(source))
    secrets = [span for span in (*marked, *named) if span.text.strip("* \t\r\n")]
    return Mask(secrets) if secrets else None


def _shown(findings: Iterable[Finding]) -> dict[Source, None]:
    """The files of which the findings may show something."""
    shown: dict[Source, None] = {}
    for finding in findings:
        edits = finding.fix.edits if finding.fix else ()
        silenced = (finding.suppression,) if finding.suppression else ()
        for part in (finding, *finding.related, *finding.chain, *edits, *silenced):
            shown[part.span.source] = None
    return shown


def widened(mask: Mask | None, sources: Iterable[Source]) -> Mask | None:
    """The mask for what these files give away, besides what it hides already."""
    named = mask_of((), sources)
    secrets = [*(mask.secrets if mask else ()), *(named.secrets if named else ())]
    return Mask(secrets) if secrets else None


def _anywhere(secret: str) -> str:
    """A pattern for a secret in any text. A mere word is left alone in a longer name, such as that of a package or an
    image: who takes the name of a program for a password must still see which image a finding is about."""
    pattern = re.escape(secret)
    return rf"(?<![_/-]){pattern}(?![_/-]|:(?:latest|\d))" if _WORD.fullmatch(secret) else pattern


class Mask:
    """Replaces secrets, character by character, so that every offset and column stays true."""

    def __init__(self, secrets: Iterable[Span]) -> None:
        self.secrets = tuple(secrets)
        self.sources: dict[Source, Source] = {}
        self.spans: dict[Source, list[Span]] = defaultdict(list)
        for span in self.secrets:
            self.spans[span.source].append(span)

    @cached_property
    def pattern(self) -> re.Pattern[str] | None:
        lines = {line.strip() for span in self.secrets for line in span.text.splitlines()}
        long = [line for line in lines if len(line) >= SHORTEST and not MERE_NAME.fullmatch(line)]
        long.sort(key=lambda line: (-len(line), line))
        return re.compile("|".join(map(_anywhere, long))) if long else None

    def words(self, text: str) -> str:
        """A message without the secrets that it quotes."""
        return self.pattern.sub(lambda match: _stars(match[0]), text) if self.pattern else text

    def source(self, source: Source) -> Source:
        """The same file with its secrets masked."""
        if source not in self.sources:
            text = list(source.text)
            for _, start, end in self.spans.get(source, ()):
                text[start:end] = _stars(source.text[start:end])
            masked = self.words("".join(text))
            self.sources[source] = source if masked == source.text else replace(source, text=masked, masked=True)
        return self.sources[source]

    def span(self, span: Span) -> Span:
        return span._replace(source=self.source(span.source))

    def finding(self, finding: Finding) -> Finding:
        silenced = finding.suppression
        return replace(
            finding,
            message=self.words(finding.message),
            span=self.span(finding.span),
            advice=self.words(finding.advice),
            related=tuple(self.related(related) for related in finding.related),
            chain=tuple(self.related(step) for step in finding.chain),
            fix=finding.fix and self.fix(finding.fix),
            hidden=tuple(self.span(span) for span in finding.hidden),
            secrets=tuple(self.span(span) for span in finding.secrets),
            suppression=silenced
            and silenced._replace(span=self.span(silenced.span), reason=self.words(silenced.reason)),
        )

    def related(self, related: Related) -> Related:
        return Related(self.span(related.span), self.words(related.message))

    def fix(self, fix: Fix) -> Fix:
        edits = tuple(Edit(self.span(edit.span), self.words(edit.text)) for edit in fix.edits)
        return replace(fix, title=self.words(fix.title), edits=edits, codemod=None)


def _stars(secret: str) -> str:
    return re.sub(r"[^\r\n]", "*", secret)
