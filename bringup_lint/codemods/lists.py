"""Moving and removing elements of list literals: actions of a launch description, remappings, node names.

Comment lines above an element and the comment after it move with it; a list on one line keeps its blanks.
"""

from __future__ import annotations

import ast
from collections.abc import Callable
from collections.abc import Sequence
from functools import partial
from typing import TYPE_CHECKING
from typing import TypeVar

from bringup_lint.codemods.module import BOM
from bringup_lint.codemods.module import read
from bringup_lint.finding import Codemod
from bringup_lint.model.python import syntax_of
from bringup_lint.named_tuple import NamedTuple
from bringup_lint.source import Source
from bringup_lint.source import Span

if TYPE_CHECKING:
    import libcst

_Gap = TypeVar("_Gap")


def move_before(moved: Span, other: Span) -> Codemod | None:
    """Move the element that holds one span before the element that holds another; None unless they share a list."""
    return _moving(moved, other, 0)


def move_after(moved: Span, other: Span) -> Codemod | None:
    """The same, to the place after the other element."""
    return _moving(moved, other, 1)


def remove(span: Span) -> Codemod | None:
    """Remove the element that holds the span; None when no list literal holds it."""
    if not _in_one_list(span.source, span.start, span.start):
        return None
    return Codemod(span.source, partial(_rearranged, at=(span.start, span.start), order=_without))


def _moving(moved: Span, other: Span, after: int) -> Codemod | None:
    at = (moved.start, other.start)
    if moved.source is not other.source or not _in_one_list(moved.source, *at, apart=True):
        return None
    return Codemod(moved.source, partial(_rearranged, at=at, order=partial(_moved, after=after)))


def _moved(count: int, first: int, second: int, after: int) -> list[int]:
    """The order of the elements when ``first`` goes before or after ``second``."""
    if (first < second) != bool(after):
        return list(range(count))
    order = [index for index in range(count) if index != first]
    order.insert(order.index(second) + after, first)
    return order


def _without(count: int, first: int, _: int) -> list[int]:
    return [index for index in range(count) if index != first]


def _in_one_list(source: Source, first: int, second: int, *, apart: bool = False) -> bool:
    """Whether the innermost list literal that holds both offsets holds them in elements, in different ones if asked."""
    if not source.name.endswith(".py"):
        return False
    tree = syntax_of(source.text.removeprefix(BOM))
    if tree is None:
        return False
    lines = source.text.removeprefix(BOM).split("\n")
    starts = [len(source.text) - len(source.text.removeprefix(BOM))]
    for line in lines:
        starts.append(starts[-1] + len(line) + 1)

    def offset(line: int, column: int) -> int:
        return starts[line - 1] + len(lines[line - 1].encode()[:column].decode("utf-8", "replace"))

    found: list[tuple[int, bool]] = []
    for node in ast.walk(tree):
        if isinstance(node, ast.List):
            spans = [
                (offset(each.lineno, each.col_offset), offset(each.end_lineno or 0, each.end_col_offset or 0))
                for each in node.elts
            ]
            held = [_holding(spans, at) for at in (first, second)]
            if None not in held:
                found.append((spans[-1][1] - spans[0][0], held[0] != held[1]))
    return bool(found) and (min(found)[1] or not apart)


def _holding(spans: Sequence[tuple[int, int]], at: int) -> int | None:
    """The index of the stretch that holds an offset."""
    return next((index for index, (start, end) in enumerate(spans) if start <= at < end), None)


class _Item(NamedTuple):
    """An element with the comments that belong to it."""

    element: libcst.BaseElement
    above: Sequence[libcst.EmptyLine]
    beside: libcst.TrailingWhitespace | None


def _rearranged(text: str, at: tuple[int, int], order: Callable[[int, int, int], list[int]]) -> str:
    """The text with the elements of the innermost list that holds both offsets in another order."""
    import libcst

    module = read(text)
    offsets = [module.offset(each) for each in at]
    best: tuple[int, libcst.List, list[int]] | None = None
    for node, (start, end) in module.offsets.items():
        if not isinstance(node, libcst.List) or not node.elements:
            continue
        spans = [module.offsets[each.value] for each in node.elements]
        held = [_holding(spans, each) for each in offsets]
        indexes = [each for each in held if each is not None]
        if len(indexes) == 2 and (best is None or end - start < best[0]):
            best = (end - start, node, indexes)
    if best is None:
        return text
    _, found, (first, second) = best
    arranged = order(len(found.elements), first, second)
    if arranged == list(range(len(found.elements))):
        return text
    return module.replaced(found, _list_of(found, arranged))


def _list_of(node: libcst.List, order: list[int]) -> libcst.List:
    """The list with its elements in another order; the places between elements keep their commas and blanks."""
    import libcst

    gaps = _gaps(node)
    whole = [gap for gap in gaps if isinstance(gap, libcst.ParenthesizedWhitespace)]
    if len(whole) < len(gaps):
        return _filled(node, [node.elements[index] for index in order], _fewer(gaps, len(order)))
    items = [_Item(node.elements[index], whole[index].empty_lines, whole[index + 1].first_line) for index in order]
    arranged: list[libcst.BaseParenthesizableWhitespace] = []
    for index, gap in enumerate(_fewer(whole, len(order))):
        above = items[index].above if index < len(items) else gap.empty_lines
        beside = items[index - 1].beside if index else gap.first_line
        arranged.append(gap.with_changes(first_line=beside, empty_lines=above))
    return _filled(node, [item.element for item in items], arranged)


def _gaps(node: libcst.List) -> list[libcst.BaseParenthesizableWhitespace]:
    """What is before the first element, between the elements, and after the last one."""
    import libcst

    between = [
        element.comma.whitespace_after for element in node.elements[:-1] if isinstance(element.comma, libcst.Comma)
    ]
    return [node.lbracket.whitespace_after, *between, node.rbracket.whitespace_before]


def _fewer(gaps: Sequence[_Gap], count: int) -> list[_Gap]:
    """The gaps for fewer elements: the very last one stays."""
    return [*gaps[:count], gaps[-1]]


def _filled(
    node: libcst.List,
    elements: Sequence[libcst.BaseElement],
    gaps: Sequence[libcst.BaseParenthesizableWhitespace],
) -> libcst.List:
    """The list with these elements and the blanks between them; a comma after the last one stays."""
    import libcst

    commas = [libcst.Comma(whitespace_after=gap) for gap in gaps[1:-1]]
    made = [element.with_changes(comma=comma) for element, comma in zip(elements, [*commas, node.elements[-1].comma])]
    return node.with_changes(
        elements=made,
        lbracket=node.lbracket.with_changes(whitespace_after=gaps[0]),
        rbracket=node.rbracket.with_changes(whitespace_before=gaps[-1]),
    )
