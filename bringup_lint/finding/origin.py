"""Findings about a file that another file writes are shown in the file that writes it."""

from __future__ import annotations

from itertools import pairwise

from bringup_lint.dataclass import replace
from bringup_lint.finding import Confidence
from bringup_lint.finding import Edit
from bringup_lint.finding import Finding
from bringup_lint.finding import Fix
from bringup_lint.finding import Related
from bringup_lint.pattern import regex
from bringup_lint.source import Origin
from bringup_lint.source import Source
from bringup_lint.source import Span

_EXPANDED = ("$", "`", "\\", "{{", "{%", "{#")
"""What a shell or Jinja would expand in an edit."""
_PLAIN = regex(r"(?:[\w ./=,@%+-]|:(?! ))*")
"""What needs no quotes where it is not clear what is around it."""
_INNER_END = regex(r"\n(?=[^\r\n])")
_LEAST_LINES = 2
"""Lines that show how the file that writes goes from one line to the next."""


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
    edits = tuple(map(_carried, fix.edits))
    if any(edit is None for edit in edits):
        return None
    return replace(fix, edits=tuple(edit for edit in edits if edit is not None))


def _carried(edit: Edit) -> Edit | None:
    """An edit in the file that writes; None where it is not clear what it would be there."""
    origin = edit.span.source.origin
    if origin is None:
        return edit
    span = _stretch(origin, edit.span)
    if not origin.verbatim or span.text != edit.span.text or any(mark in edit.text for mark in _EXPANDED):
        return None
    margin = _margin(edit.span.source, origin)
    if "\n" in edit.text or "\n" in edit.span.text:
        return _lines(edit, span, margin) if margin is not None else None
    return Edit(span, edit.text) if margin is not None or _PLAIN.fullmatch(edit.text) else None


def _stretch(origin: Origin, span: Span) -> Span:
    """Where an edit is in the file that writes: before the first character, not where the file is named."""
    if span.end > 0:
        return origin.span(span.start, span.end)
    at = origin.span(0, 1).start
    return Span(origin.whole.source, at, at)


def _margin(source: Source, origin: Origin) -> str | None:
    """The blanks before each line of a text in the file that writes it, line below line, such as those of a YAML
    block; None where other text is before a line, lines are folded, or a single line cannot say."""
    writer = origin.whole.source
    places = [(at, origin.span(at, at + 1).start) for at in source.line_starts if at < len(source.text)]
    numbers = [writer.position(place).line for _, place in places]
    if len(places) < _LEAST_LINES or any(after - before != 1 for before, after in pairwise(numbers)):
        return None
    margins = {_before(writer, place) for at, place in places if source.text[at] not in "\r\n"}
    return margins.pop() if len(margins) == 1 and not "".join(margins).strip() else None


def _before(source: Source, at: int) -> str:
    """What a line holds before a place."""
    return source.text[source.line_starts[source.position(at).line - 1] : at]


def _lines(edit: Edit, span: Span, margin: str) -> Edit | None:
    """An edit that adds or removes lines, with the margin of the lines around it."""
    before = _before(span.source, span.start)
    if edit.span.text.endswith("\n") and not edit.text.endswith("\n"):
        whole = span._replace(start=span.start - len(margin))
        return Edit(whole, "") if not edit.text and before == margin else None
    text = _INNER_END.sub(lambda _: "\n" + margin, edit.text)
    if edit.span.column == 1 and not text.startswith("\n"):
        text = margin.removeprefix(before) + text
    follows = span.source.text[span.end : span.end + 1] not in ("", "\r", "\n")
    if text.endswith("\n") and follows and _before(span.source, span.end):
        text += margin
    return Edit(span, text)
