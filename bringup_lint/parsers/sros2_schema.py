"""The structure of security documents: elements, their order and their values, by the table ``dds/sros2.tsv``."""

from __future__ import annotations

from collections.abc import Iterator
from functools import cache
from typing import NamedTuple

from bringup_lint.facts import table
from bringup_lint.model.sros2 import Remark
from bringup_lint.model.sros2 import moment
from bringup_lint.model.xml import Element


class Item(NamedTuple):
    """An element of the table."""

    name: str
    order: int
    """0 where any place will do."""
    required: bool
    single: bool
    type: str
    allowed: tuple[str, ...]
    children: dict[str, Item]
    attributes: dict[str, bool]
    """Name -> whether it is required."""
    values: dict[str, tuple[str, ...]]
    """Attribute -> its words, where only some are allowed."""


@cache
def schema(file: str) -> Item:
    """The root element of ``governance``, ``permissions`` or ``policy``."""
    items: dict[str, Item] = {}
    for row in table("dds/sros2"):
        if row["file"] != file:
            continue
        path, required = row["path"], row["required"] == "yes"
        if row["kind"] == "attribute":
            owner, _, name = path.rpartition("@")
            items[owner].attributes[name] = required
            if row["type"] == "enum":
                items[owner].values[name] = tuple(row["allowed"].split("|"))
            continue
        above, _, name = path.rpartition("/")
        order = int(row["order"] or 0)
        item = Item(
            name, order, required, row["max_occurs"] == "1", row["type"], tuple(row["allowed"].split("|")), {}, {}, {}
        )
        items[path] = item
        if above:
            items[above].children[name] = item
    return next(iter(items.values()))


def check(element: Element, item: Item) -> Iterator[Remark]:
    """What is wrong with an element and all below it."""
    for name, required in item.attributes.items():
        if required and element.get(name) is None:
            yield Remark("attribute", element.name, name, element)
    if item.children:
        yield from _children(element, item)
    elif not element.children:
        yield from _value(element, item)


def _children(element: Element, item: Item) -> Iterator[Remark]:
    reached, seen, in_order = 0, set(), True
    for child in element.children:
        known = item.children.get(child.local)
        if known is None:
            if ":" not in child.name:
                yield Remark("unknown", child.name, str(child.name), child)
            continue
        if known.single and known.name in seen:
            yield Remark("duplicate", child.name, known.name, child)
        elif in_order and known.order and known.order < reached:
            in_order = False
            yield Remark("order", child.name, known.name, child)
        seen.add(known.name)
        reached = max(reached, known.order)
        yield from check(child, known)
    for known in item.children.values():
        if known.required and known.name not in seen:
            later = [child for child in element.children if _order(item, child) > known.order]
            yield Remark("missing", element.name, known.name, element, later[0] if later else None)


def _order(item: Item, child: Element) -> int:
    known = item.children.get(child.local)
    return known.order if known else 0


def _value(element: Element, item: Item) -> Iterator[Remark]:
    text = element.text
    where = text if text else element.tag
    if item.type == "bool" and text not in item.allowed:
        yield Remark("bool", where, item.name, element)
    elif item.type == "enum" and text not in item.allowed:
        yield Remark("default" if item.name == "default" else "kind", where, item.name, element)
    elif item.type == "int" and not (text.isascii() and text.isdigit()):
        yield Remark("number", where, item.name, element)
    elif item.type == "dateTime" and moment(text) is None:
        yield Remark("date", where, item.name, element)
    elif item.type == "string" and not text and item.name in ("topic_expression", "topic", "subject_name"):
        yield Remark("empty", where, item.name, element)
