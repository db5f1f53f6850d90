"""Masks secrets: what a finding marks as secret, or a file shows by its name to be one, no report prints."""

from __future__ import annotations

import re
from collections import defaultdict
from collections.abc import Iterable
from collections.abc import Set as AbstractSet
from functools import cached_property

from bringup_lint.dataclass import replace
from bringup_lint.finding import Edit
from bringup_lint.finding import Finding
from bringup_lint.finding import Fix
from bringup_lint.finding import Related
from bringup_lint.finding.common_words import is_common
from bringup_lint.finding.common_words import parts_of_paths
from bringup_lint.finding.place import inside
from bringup_lint.finding.secrets import MERE_NAME
from bringup_lint.finding.secrets import given_away
from bringup_lint.pattern import regex
from bringup_lint.source import Source
from bringup_lint.source import Span

SHORTEST = 6
"""A secret of fewer characters is masked where it is marked, not in every text that happens to hold it."""


NEAR = 3
"""Lines around a secret in which it is masked though it is a common word: a code frame shows them beside it."""
_WORD = regex(r"[A-Za-z]{1,11}")


def mask_of(findings: Iterable[Finding], sources: Iterable[Source] = ()) -> Mask | None:
    """The mask for the secrets of these findings, the files they show and these files; None when there are none."""
    findings = tuple(findings)
    marked = (inside(span) for finding in findings for span in finding.secrets)
    shown = _shown(findings) | dict.fromkeys(sources)
    named = (span for source in shown for span in given_away(source))
    secrets = [span for span in (*marked, *named) if span.text.strip("* \t\r\n")]
    return Mask(secrets, parts_of_paths(shown)) if secrets else None


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
    known = [each for each in (mask, mask_of((), sources)) if each is not None]
    secrets = [span for each in known for span in each.secrets]
    return Mask(secrets, frozenset().union(*(each.parts for each in known))) if secrets else None


def _anywhere(secret: str) -> str:
    """A pattern for a secret in any text. A mere word is left alone in a longer name, such as that of a package or an
    image: who takes the name of a program for a password must still see which image a finding is about."""
    pattern = re.escape(secret)
    return rf"(?<![_/-]){pattern}(?![_/-]|:(?:latest|\d))" if _WORD.fullmatch(secret) else pattern


class Mask:
    """Replaces secrets, character by character, so that every offset and column stays true."""

    def __init__(self, secrets: Iterable[Span], parts: frozenset[str] = frozenset()) -> None:
        """``parts``: the words of the paths that are shown."""
        self.secrets = tuple(secrets)
        self.parts = parts
        self.sources: dict[Source, Source] = {}
        self.spans: dict[Source, list[Span]] = defaultdict(list)
        for span in self.secrets:
            self.spans[span.source].append(span)

    @cached_property
    def _lines(self) -> frozenset[str]:
        lines = {line.strip() for span in self.secrets for line in span.text.splitlines()}
        return frozenset(line for line in lines if len(line) >= SHORTEST and not MERE_NAME.fullmatch(line))

    @cached_property
    def common(self) -> frozenset[str]:
        """The secrets that are common words: they are masked where they stand as a secret, and near there."""
        return frozenset(line for line in self._lines if is_common(line, self.parts))

    @cached_property
    def pattern(self) -> re.Pattern[str] | None:
        return _any_of(self._lines - self.common)

    @cached_property
    def _near(self) -> dict[Source, dict[int, set[str]]]:
        """Source -> line -> the common words that are a secret near it."""
        found: dict[Source, dict[int, set[str]]] = {}
        for span in self.secrets:
            if (word := span.text.strip()) in self.common:
                lines = found.setdefault(span.source, {})
                for line in range(span.line - NEAR, span.line + NEAR + 1):
                    lines.setdefault(line, set()).add(word)
        return found

    def words(self, text: str, near: Iterable[Span] = ()) -> str:
        """A text without the secrets that it quotes; ``near`` is what it is about."""
        if self.pattern:
            text = self.pattern.sub(lambda match: _stars(match[0]), text)
        if self.common:
            told = {span.text for span in given_away(Source("", text))}
            told.update(*(self._near.get(span.source, {}).get(span.line, ()) for span in near))
            text = _without(text, told & self.common)
        return text

    def source(self, source: Source) -> Source:
        """The same file with its secrets masked."""
        if source not in self.sources:
            text = list(source.text)
            for _, start, end in self.spans.get(source, ()):
                text[start:end] = _stars(source.text[start:end])
            starts = [0, *source.line_starts, len(source.text)]
            for line, words in self._near.get(source, {}).items():
                start, end = starts[line : line + 2] if 0 < line < len(starts) - 1 else (0, 0)
                text[start:end] = _without("".join(text[start:end]), words)
            masked = "".join(text)
            masked = self.pattern.sub(lambda match: _stars(match[0]), masked) if self.pattern else masked
            self.sources[source] = source if masked == source.text else replace(source, text=masked, masked=True)
        return self.sources[source]

    def span(self, span: Span) -> Span:
        return span._replace(source=self.source(span.source))

    def finding(self, finding: Finding) -> Finding:
        silenced = finding.suppression
        about = (finding.span, *finding.secrets, *(each.span for each in (*finding.related, *finding.chain)))
        return replace(
            finding,
            message=self.words(finding.message, about),
            span=self.span(finding.span),
            advice=self.words(finding.advice, about),
            related=tuple(self.related(related, about) for related in finding.related),
            chain=tuple(self.related(step, about) for step in finding.chain),
            fix=finding.fix and self.fix(finding.fix, about),
            hidden=tuple(self.span(span) for span in finding.hidden),
            secrets=tuple(self.span(span) for span in finding.secrets),
            suppression=silenced
            and silenced._replace(span=self.span(silenced.span), reason=self.words(silenced.reason, about)),
        )

    def related(self, related: Related, about: Iterable[Span] = ()) -> Related:
        return Related(self.span(related.span), self.words(related.message, about))

    def fix(self, fix: Fix, about: Iterable[Span] = ()) -> Fix:
        edits = tuple(Edit(self.span(edit.span), self.words(edit.text, (*about, edit.span))) for edit in fix.edits)
        return replace(fix, title=self.words(fix.title, about), edits=edits, codemod=None)


def _any_of(secrets: AbstractSet[str]) -> re.Pattern[str] | None:
    ordered = sorted(secrets, key=lambda line: (-len(line), line))
    return re.compile("|".join(map(_anywhere, ordered))) if ordered else None


def _without(text: str, secrets: AbstractSet[str]) -> str:
    pattern = _any_of(secrets)
    return pattern.sub(lambda match: _stars(match[0]), text) if pattern else text


def _stars(secret: str) -> str:
    return re.sub(r"[^\r\n]", "*", secret)
