"""Comments that silence findings: ``bringup-lint: ignore[systemd/root-user]: why`` and ``ignore-file[...]``.

A comment counts for its own line; on a line of its own (systemd and udev have no trailing comments) for the next
statement to its last line, and for the comments between. Above everything else, it also counts for what is said of the
file as a whole. ``ignore-file`` counts for all of the file. A name may be a rule, a family, or one of a rule's older
names.
"""

from __future__ import annotations

from collections.abc import Callable
from collections.abc import Iterable
from collections.abc import Iterator

from bringup_lint.dataclass import dataclass
from bringup_lint.dataclass import field
from bringup_lint.dataclass import replace
from bringup_lint.finding import Finding
from bringup_lint.finding import Suppression
from bringup_lint.finding.place import is_whole_file
from bringup_lint.ignore_marks import MARK
from bringup_lint.source import Source
from bringup_lint.source import Span
from bringup_lint.suppress.comments import Ignore
from bringup_lint.suppress.comments import read
from bringup_lint.suppress.forms import HASH
from bringup_lint.suppress.forms import form_of

UNUSED = "lint/unused-ignore"
WITHOUT_REASON = "lint/ignore-without-reason"


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
                if _counts(ignore, span) and self.is_name_of(ignore.name, finding.rule):
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
                about_comments = self.is_name_of(ignore.name, UNUSED) or self.is_name_of(ignore.name, WITHOUT_REASON)
                if not ignore.used and not about_comments and ran(ignore.name):
                    yield _unused(ignore)
                if not ignore.reason:
                    yield _without_reason(ignore)


def ignores_in(sources: Iterable[Source], is_name_of: Callable[[str, str], bool]) -> Ignores:
    """Read the suppression comments of all judged sources."""
    ignores = Ignores(is_name_of=is_name_of)
    for source in sources:
        if source.judged and source.origin is None and MARK in source.text:
            ignores.by_source[id(source)] = list(read(source))
    return ignores


def _counts(ignore: Ignore, span: Span) -> bool:
    """Whether a comment counts for a place of its file."""
    if ignore.lines is None:
        return True
    return ignore.head if is_whole_file(span) else span.line in ignore.lines


def _unused(ignore: Ignore) -> Finding:
    return Finding(
        f"ignore[{ignore.name}] silences nothing here",
        ignore.name.span,
        rule=UNUSED,
        advice="delete the name, or correct it",
    )


def _without_reason(ignore: Ignore) -> Finding:
    form = form_of(ignore.name.span.source) or HASH
    what = "ignore-file" if ignore.lines is None else "ignore"
    return Finding(
        f"ignore[{ignore.name}] gives no reason",
        ignore.name.span,
        rule=WITHOUT_REASON,
        advice="say why: " + form(f"bringup-lint: {what}[{ignore.name}]: the reason"),
    )
