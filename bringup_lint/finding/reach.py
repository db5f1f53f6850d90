"""Whether a change of files has a part in a finding."""

from __future__ import annotations

import re
from collections.abc import Callable
from collections.abc import Collection
from collections.abc import Iterable

from bringup_lint.finding import Finding
from bringup_lint.finding.place import inside

ABOUT_THE_RUN = "lint/internal-error"


def reached(findings: Iterable[Finding], touched: Callable[[str], bool], gone: Collection[str] = ()) -> list[Finding]:
    """The findings whose place, related places or steps lie in a file that changed, and those that speak of a file that
    is gone, which nothing else could show.

    ``touched`` is asked for the names of sources; ``gone`` are the names of deleted files, without folders.
    """
    words = re.compile("|".join(rf"(?<![\w.-]){re.escape(name)}(?![\w-])" for name in sorted(gone))) if gone else None

    def counts(finding: Finding) -> bool:
        if finding.rule == ABOUT_THE_RUN or any(map(touched, _names(finding))):
            return True
        return words is not None and words.search(_text(finding)) is not None

    return list(filter(counts, findings))


def _names(finding: Finding) -> Iterable[str]:
    parts = (finding.span, *(part.span for part in (*finding.related, *finding.chain)), *finding.hidden)
    return dict.fromkeys(span.source.name for span in parts)


def _text(finding: Finding) -> str:
    source, start, _ = inside(finding.span)
    return f"{finding.message}\n{finding.advice}\n{source.line_text(source.position(start).line)}"
