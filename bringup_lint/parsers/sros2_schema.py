"""The structure of security documents and policies: elements, their order and their values."""

from __future__ import annotations

from collections.abc import Iterator
from functools import cache

from bringup_lint.facts import table
from bringup_lint.model.schema import Code
from bringup_lint.model.schema import Fault
from bringup_lint.model.schema import Item
from bringup_lint.model.schema import Remark
from bringup_lint.model.sros2 import moment
from bringup_lint.model.xml import Element
from bringup_lint.schema.names import Spelling
from bringup_lint.schema.table import Schema
from bringup_lint.schema.table import schema_of
from bringup_lint.schema.walk import Entry
from bringup_lint.schema.walk import walk

WITHOUT_PREFIX = Spelling(drops_prefix=True)
NEVER_EMPTY = ("topic_expression", "topic", "subject_name")
_OF_XML = ("xmlns", "xml:", "xsi:")


@cache
def schema(file: str) -> Schema:
    """The schema of ``governance``, ``permissions`` or ``policy``."""
    return schema_of(row for row in table("dds/sros2") if row["file"] == file)


def check(root: Element, file: str) -> Iterator[Remark]:
    """What is wrong with a document, whatever its root is called. Elements with a prefix are left alone."""
    known = schema(file)
    top = next(iter(known.top.children.values()))
    for remark in walk(known, _entry(root), top, fault_of, WITHOUT_PREFIX):
        if remark.code is not Code.UNKNOWN or ":" not in str(remark.where):
            yield remark


def _entry(element: Element) -> Entry:
    attributes = [
        Entry(each.name, each.value, element=element)
        for each in element.attributes
        if not each.name.startswith(_OF_XML)
    ]
    return Entry(element.name, element.text, [_entry(child) for child in element.children], attributes, element)


def fault_of(item: Item, text: str) -> Fault | None:
    """What a security plugin or sros2 has against a text."""
    if item.type == "bool":
        return None if text in item.words else Fault(Code.BOOL)
    if item.type == "enum":
        return None if text in item.words else Fault(Code.ENUM)
    if item.type == "int":
        return None if text.isascii() and text.isdecimal() else Fault(Code.NUMBER)
    if item.type == "dateTime":
        return None if moment(text) is not None else Fault(Code.DATE)
    return None if text or item.name not in NEVER_EMPTY else Fault(Code.EMPTY)
