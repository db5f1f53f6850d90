"""Comments that silence findings: ``bringup-lint: ignore[systemd/root-user] -- why`` and ``ignore-file[...]``.

A comment counts for its own line; on a line of its own (systemd and udev have no trailing comments) for the next line
that is no comment. ``ignore-file`` counts for the whole file. A name may be a rule, a family, or one of a rule's
older names.
"""

from __future__ import annotations

import re
from collections.abc import Callable
from collections.abc import Iterable
from collections.abc import Iterator
from dataclasses import dataclass
from dataclasses import field
from dataclasses import replace

from bringup_lint.finding import Finding
from bringup_lint.finding import Suppression
from bringup_lint.source import Located
from bringup_lint.source import Source

MARK = "bringup-lint:"
UNUSED = "lint/unused-ignore"
WITHOUT_REASON = "lint/ignore-without-reason"

_COMMENT = re.compile(
    r"(?:#|;|//|<!--)\s*bringup-lint:\s*(?P<what>ignore(?:-file)?)\s*\[(?P<names>[^][\n]*)\]"
    r"(?:\s*--\s*(?P<reason>[^\n]*))?"
)
_COMMENT_LINE = re.compile(r"\s*(?:#|;|//|<!--)|\s*$")


@dataclass(eq=False)
class Ignore:
    """One name in one comment."""

    name: Located
    reason: str
    line: int | None
    """The line it counts for; None for the whole file."""
    used: bool = False


@dataclass(eq=False)
class Ignores:
    """All suppression comments of a tree."""

    by_source: dict[int, list[Ignore]] = field(default_factory=dict)
    is_name_of: Callable[[str, str], bool] = lambda name, rule: name == rule
    """Whether a name in a comment means a rule id."""

    def apply(self, finding: Finding) -> Finding:
        """The finding, with its suppression when a comment silences it."""
        for span in (finding.span, *finding.hidden):
            for ignore in self.by_source.get(id(span.source), ()):
                if ignore.line in (None, span.line) and self.is_name_of(ignore.name, finding.rule):
                    ignore.used = True
                    return replace(finding, suppression=Suppression(ignore.name.span, ignore.reason))
        return finding

    def complaints(self, ran: Callable[[str], bool]) -> Iterator[Finding]:
        """Comments that hit nothing, though what they name ran, and comments that give no reason.

        A link to a file, such as an enabled unit, is another source with the same comments: the file speaks for them.
        """
        for ignores in self.by_source.values():
            if not ignores or ignores[0].name.span.source.link is not None:
                continue
            for ignore in ignores:
                if not ignore.used and ran(ignore.name):
                    yield Finding(
                        f"ignore[{ignore.name}] silences nothing here",
                        ignore.name.span,
                        rule=UNUSED,
                        advice="delete the name, or correct it",
                    )
                if not ignore.reason:
                    yield Finding(
                        f"ignore[{ignore.name}] gives no reason",
                        ignore.name.span,
                        rule=WITHOUT_REASON,
                        advice=f"say why: bringup-lint: ignore[{ignore.name}] -- the reason",
                    )


def ignores_in(sources: Iterable[Source], is_name_of: Callable[[str, str], bool]) -> Ignores:
    """Read the suppression comments of all judged sources."""
    ignores = Ignores(is_name_of=is_name_of)
    for source in sources:
        if source.judged and source.origin is None and MARK in source.text:
            ignores.by_source[id(source)] = list(_read(source))
    return ignores


def _read(source: Source) -> Iterator[Ignore]:
    read = 0
    for match in _COMMENT.finditer(source.text):
        lead = source.text[max(source.text.rfind("\n", read, match.start()) + 1, read) : match.start()]
        read = match.end()
        line: int | None = None
        if match["what"] == "ignore":
            line = source.position(match.end("names")).line
            if not lead.strip():
                line = _next_line(source, line)
        names = source.located(*match.span("names"))
        reason = (match["reason"] or "").strip().removesuffix("-->").rstrip()
        for part in re.finditer(r"[^,\s]+", names):
            yield Ignore(names.part(*part.span()), reason, line)


def _next_line(source: Source, line: int) -> int:
    """The next line after a comment that is no comment."""
    last = len(source.line_starts)
    while line < last and _COMMENT_LINE.match(source.line_text(line)) and source.line_text(line).strip():
        line += 1
    return line
