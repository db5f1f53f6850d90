"""Local numbers of a C++ file that are added to before they have a value."""

from __future__ import annotations

import re
from collections.abc import Iterator
from itertools import islice
from typing import TYPE_CHECKING

from bringup_lint.model.cpp_source import Unset
from bringup_lint.model.cpp_text import blanked
from bringup_lint.parsers.cpp_node.syntax import Code
from bringup_lint.pattern import regex

if TYPE_CHECKING:
    from tree_sitter import Node

NUMBERS = 500
"""Declarations of one file that are looked at."""
WINDOW = 4_000
"""Code points behind a declaration that are looked at."""
_NUMBERS = regex(
    r"(?:unsigned\s+|signed\s+)?(?:double|float|int|long|short|unsigned|(?:std::)?(?:size_t|u?int\d+_t))\Z"
)
_NAMED = r"\b{0}\b"
_CHANGED = r"(?P<changed>(?<![\w.>&]){0}\s{{0,4}}(?:[-+*/|]=|\+\+|--)|(?:\+\+|--){0}\b)"
"""The name as what is added to, and the like."""
_SET = r"(?<![\w.>])(?:{0}\s{{0,4}}=(?!=)|>>\s{{0,4}}{0}\b|&\s{{0,4}}{0}\b)"
"""The name as what gets a value, or may by its address."""
_ELEMENT_CHANGED = (
    r"(?P<changed>(?<![\w.>&]){0}\s{{0,4}}\[[^\[\]]{{1,80}}\]\s{{0,4}}(?:[-+*/|]=|\+\+|--)"
    r"|(?:\+\+|--){0}\s{{0,4}}\[)"
)
_ELEMENT_SET = (
    r"(?<![\w.]){0}\b(?!\s{{0,4}}\[[^\[\]]{{1,80}}\]\s{{0,4}}(?:[^\s\[=>]|==))"
    r"|>>\s{{0,4}}{0}\b|&\s{{0,4}}{0}\b"
)
"""The name of an array as what may get values: one of its elements, or all where it is handed over."""
_LOOP = regex(r"\b(?:for|while|do)\b")
_UNFOLLOWED = regex(r"^[ \t]*#|\bgoto\b|\[&|\b__?asm", re.M)


def unset(code: Code) -> Iterator[Unset]:
    """The first use of each local number without a value, where it is one that needs the value, and gives none
    elsewhere."""
    declared = ((each, names) for each in code.written.get("declaration", ()) if (names := _names(code, each)))
    for declaration, names in islice(declared, NUMBERS):
        rest = _rest(code, declaration)
        followed = _UNFOLLOWED.search(rest) is None
        for name in names:
            patterns = (_CHANGED, _SET) if _declarator(name) is name else (_ELEMENT_CHANGED, _ELEMENT_SET)
            found = _changed(rest, code.text(name), *patterns) if followed else None
            if found is not None:
                start = code.offset(declaration.end_byte)
                used = code.source.span(start + found[0], start + found[1])
                loops = len(_LOOP.findall(rest, 0, found[0]))
                is_kept = _is_from_itself(rest, found[1], code.text(name)) and loops <= (
                    patterns[0] is _ELEMENT_CHANGED
                )
                yield Unset(code.span(_declarator(name)), used, code.text(name), is_kept)


def _names(code: Code, declaration: Node) -> list[Node]:
    """The names of plain numbers, and of arrays of them, that a statement of a function declares without a value."""
    parent, written = declaration.parent, declaration.child_by_field_name("type")
    if parent is None or parent.type != "compound_statement" or written is None:
        return []
    if not _NUMBERS.match(code.text(written)):
        return []
    if any(each.type in ("storage_class_specifier", "type_qualifier") for each in declaration.children):
        return []
    found = []
    for each in declaration.children_by_field_name("declarator"):
        plain = each.child_by_field_name("declarator") if each.type == "array_declarator" else each
        if plain is not None and plain.type == "identifier":
            found.append(plain)
    return found


def _declarator(name: Node) -> Node:
    """``x[3]`` of an array, where it is declared."""
    outer = name.parent
    return outer if outer is not None and outer.type == "array_declarator" else name


def _rest(code: Code, declaration: Node) -> str:
    """The text of the block behind a declaration, without comments."""
    block = declaration.parent
    end = block.end_byte if block is not None else declaration.end_byte
    first, last = code.offset(declaration.end_byte), code.offset(end)
    return blanked(code.source.text[first : min(last, first + WINDOW)])


def _is_from_itself(rest: str, start: int, name: str) -> bool:
    """Whether what is added is computed from the value that the name has."""
    return re.search(_NAMED.format(re.escape(name)), rest[start:].partition(";")[0]) is not None


def _changed(rest: str, name: str, changes: str, sets: str) -> tuple[int, int] | None:
    """Where the first use of a name adds to it, when nothing else of the text gives it a value."""
    name = re.escape(name)
    first, changed = (re.search(words.format(name), rest) for words in (_NAMED, changes))
    if first is None or changed is None or re.search(sets.format(name), rest):
        return None
    start, end = changed.span("changed")
    return (first.start(), first.end()) if start <= first.start() <= end else None
