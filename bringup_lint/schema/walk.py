"""The walk over what is written: every name against the items of its place.

``level`` is one step, for readers that go on by themselves; ``walk`` goes down to the values.
"""

from __future__ import annotations

from collections.abc import Callable
from collections.abc import Iterable
from collections.abc import Iterator
from collections.abc import Mapping
from collections.abc import Sequence
from typing import Generic
from typing import TypeVar

from bringup_lint.dataclass import dataclass
from bringup_lint.model.schema import Code
from bringup_lint.model.schema import Fault
from bringup_lint.model.schema import Item
from bringup_lint.model.schema import Remark
from bringup_lint.model.xml import Element
from bringup_lint.schema.names import EXACT
from bringup_lint.schema.names import How
from bringup_lint.schema.names import Spelling
from bringup_lint.schema.names import find
from bringup_lint.schema.table import Schema
from bringup_lint.source import Located
from bringup_lint.source import Span

Written = TypeVar("Written")
Judge = Callable[[Item, Located], Fault | None]
"""What a program has against the value of an item; None when it takes it."""


@dataclass(frozen=True, slots=True)
class Entry:
    """One name as it is written: a section, a key, an element or an attribute."""

    name: Located
    value: Located | None = None
    """None where only other entries may be; the text of an element is its value."""
    children: Sequence[Entry] = ()
    attributes: Sequence[Entry] = ()
    element: Element | None = None


@dataclass(frozen=True, slots=True)
class Level(Generic[Written]):
    """The names of one place: those that are known, and what is to be said about the others."""

    known: list[tuple[Written, Item]]
    remarks: list[Remark]


def level(
    written: Iterable[tuple[Located, Written]],
    items: Mapping[str, Item],
    inside: Item | None,
    spelling: Spelling = EXACT,
    unknown: Code = Code.UNKNOWN,
) -> Level[Written]:
    """Match names with the items that may be at their place. A name that is not known, or shortened where that is not
    possible, is left out."""
    found: Level[Written] = Level([], [])
    for name, each in written:
        match = find(items, name, spelling)
        shortened = match.how is How.PREFIX and not spelling.shortens
        if match.item is None:
            code = Code.AMBIGUOUS if match.how is How.AMBIGUOUS else unknown
            found.remarks.append(Remark(code, name, name, item=inside))
        elif shortened:
            found.remarks.append(Remark(Code.ABBREVIATED, name, match.item.name, item=match.item))
        else:
            found.known.append((each, match.item))
            found.remarks.extend(_about(name, match.item, match.how))
    return found


def _about(name: Located, item: Item, how: How) -> Iterator[Remark]:
    """What a program says about a name that it takes."""
    if how is How.PREFIX:
        yield Remark(Code.ABBREVIATED, name, item.name, False, item)
    elif how is How.ALIAS:
        yield Remark(Code.ALIAS, name, item.name, False, item)
    elif item.deprecated:
        yield Remark(Code.DEPRECATED, name, item.name, False, item)
    elif item.ignored:
        yield Remark(Code.IGNORED, name, item.name, False, item)
    if item.since:
        yield Remark(Code.TOO_NEW, name, item.since, False, item)


def repeated(known: Iterable[tuple[Entry, Item]]) -> Iterator[Remark]:
    """What may be there once and is there again, and the first that is not in the order of the table."""
    seen: set[str] = set()
    reached, in_order = 0, True
    for entry, item in known:
        if item.once and item.name in seen:
            yield Remark(Code.DUPLICATE, entry.name, item.name, item=item, element=entry.element)
        elif in_order and item.order and item.order < reached:
            in_order = False
            yield Remark(Code.ORDER, entry.name, item.name, item=item, element=entry.element)
        seen.add(item.name)
        reached = max(reached, item.order)


def missing(items: Mapping[str, Item], known: Iterable[tuple[Written, Item]]) -> Iterator[Item]:
    """What must be there and is not."""
    there = {item.path for _, item in known}
    return (item for item in items.values() if item.required and item.path not in there)


def walk(schema: Schema, entry: Entry, item: Item, judge: Judge, spelling: Spelling = EXACT) -> Iterator[Remark]:
    """Everything that is wrong with an entry and all below it."""
    shape = schema.inside(item)
    if item.type != "any":
        yield from _attributes(entry, item, judge, spelling)
    if not shape.children:
        yield from _leaf(entry, item, judge)
        return
    if entry.value:
        yield Remark(Code.TEXT, entry.value, str(entry.name), item=item, element=entry.element)
    below = level(((each.name, each) for each in entry.children), shape.children, item, spelling)
    yield from below.remarks
    yield from repeated(below.known)
    for needed in missing(shape.children, below.known):
        after = [each.element for each, known in below.known if known.order > needed.order]
        before = after[0] if after else None
        yield Remark(Code.MISSING, entry.name, needed.name, item=needed, element=entry.element, before=before)
    for each, known in below.known:
        yield from walk(schema, each, known, judge, spelling)


def _attributes(entry: Entry, item: Item, judge: Judge, spelling: Spelling) -> Iterator[Remark]:
    own = level(
        ((each.name, each) for each in entry.attributes), item.attributes, item, spelling, Code.UNKNOWN_ATTRIBUTE
    )
    yield from own.remarks
    for needed in missing(item.attributes, own.known):
        yield Remark(Code.MISSING_ATTRIBUTE, entry.name, needed.name, item=needed, element=entry.element)
    for each, known in own.known:
        yield from _value(each, known, judge)


def _leaf(entry: Entry, item: Item, judge: Judge) -> Iterator[Remark]:
    if not entry.children:
        yield from _value(entry, item, judge)
    elif item.type != "any":
        inner = entry.children[0]
        yield Remark(Code.SHAPE, inner.name, inner.name, item=item, element=inner.element)


def _value(entry: Entry, item: Item, judge: Judge) -> Iterator[Remark]:
    fault = None if entry.value is None else judge(item, entry.value)
    if fault is not None and entry.value is not None:
        where: Located | Span = entry.value
        if not entry.value and not item.is_attribute and entry.element is not None:
            where = entry.element.tag
        yield Remark(fault.code, where, fault.detail or item.name, fault.fatal, item, entry.element)
