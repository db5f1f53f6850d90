"""Where the comment that silences a finding is written: above its statement, or at the top of the file."""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Iterable

from bringup_lint.finding import Edit
from bringup_lint.finding.place import is_whole_file
from bringup_lint.source import Source
from bringup_lint.source import Span
from bringup_lint.suppress.forms import form_of
from bringup_lint.suppress.reach import head_end
from bringup_lint.suppress.reach import is_comment
from bringup_lint.suppress.reach import prolog_end
from bringup_lint.suppress.reach import statement_end
from bringup_lint.suppress.unbroken import unbroken

_TALL = 60
"""Lines above a finding in which its statement is looked for."""


def comments(source: Source, findings: Iterable[tuple[Span, str]], reason: str) -> list[Edit]:
    """The comments that silence places of rules in a file, each in a line of its own; none where the format of the file
    has no comments. ``reason`` is one line without ``--``, which XML does not allow."""
    form = form_of(source)
    if form is None:
        return []
    rules: dict[int, set[str]] = defaultdict(set)
    for span, rule in findings:
        rules[line_below(source, 0 if is_whole_file(span) else span.line)].add(rule)
    return [
        _inserted(source, line, form(f"bringup-lint: ignore[{', '.join(sorted(names))}]: {reason}"))
        for line, names in sorted(rules.items())
    ]


def line_below(source: Source, line: int) -> int:
    """The number of the line above which a comment for ``line`` is written, 0 meaning the file as a whole."""
    first = prolog_end(source) + 1
    if line <= head_end(source):
        return first
    whole = unbroken(source)
    start = max(first, whole.around(line).start)
    above = (at for at in range(max(first, start - _TALL), start) if not is_comment(source, at))
    open_ones = (at for at in above if whole.takes_comment(at))
    return next((at for at in open_ones if statement_end(source, at) >= start), start)


def _inserted(source: Source, line: int, comment: str) -> Edit:
    starts = source.line_starts
    if line > len(starts):
        end = len(source.text)
        return Edit(source.span(end, end), f"\n{comment}\n")
    start = starts[line - 1]
    text = source.line_text(line)
    indent = text[: len(text) - len(text.lstrip(" \t"))]
    return Edit(source.span(start, start), f"{indent}{comment}\n")
