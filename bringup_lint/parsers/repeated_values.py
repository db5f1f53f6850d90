"""Whether a change of a place of YAML changes other places, which repeat it with an alias."""

from __future__ import annotations

from bringup_lint.finding import Fix
from bringup_lint.parsers.yaml_kinds import YAML_KINDS
from bringup_lint.source import Source
from bringup_lint.source import Span


def changes_repeated_values(fix: Fix) -> bool:
    """Whether an edit lies in a value that an alias repeats."""
    return any(_is_repeated(edit.span) for edit in fix.edits)


def _is_repeated(span: Span) -> bool:
    source = span.source
    if source.kind not in YAML_KINDS or "&" not in source.text or "*" not in source.text:
        return False
    spans = source.once(changes_repeated_values, lambda: _repeated(source))
    return any(each.start <= span.end and span.start <= each.end for each in spans)


def _repeated(source: Source) -> list[Span]:
    """The values that aliases repeat, without those inside one another."""
    from bringup_lint.parsers.yaml_nodes import parse

    found: list[Span] = []
    nodes = {id(node): node.span for node in parse(source, follow_aliases=False).repeated}
    for span in sorted(nodes.values(), key=lambda span: (span.start, -span.end)):
        if not found or span.end > found[-1].end:
            found.append(span)
    return found
