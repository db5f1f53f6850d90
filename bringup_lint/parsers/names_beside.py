"""The names beside a name: a key, attribute or element that is renamed must not become one that is there already."""

from __future__ import annotations

from collections import Counter
from collections.abc import Container
from functools import lru_cache

from bringup_lint.model.xml import Document
from bringup_lint.model.yaml_node import Mapping
from bringup_lint.parsers.xml_tags import start_tag
from bringup_lint.parsers.yaml_nodes import parse
from bringup_lint.source import Located
from bringup_lint.source import Source
from bringup_lint.source import Span
from bringup_lint.spelling import nearest

MOST_NAMES = 64
"""Among more than so many, nobody looks which ones mean the same."""


def is_free(new: str, old: str, names: Counter[str], known: Container[str] = ()) -> bool:
    """Whether a name that takes the place of another is there only once afterwards: it is not among the names yet, and
    none of the others, known ones aside, would become it, too."""
    if new in names or names[old] > 1 or len(names) > MOST_NAMES:
        return False
    return not any(nearest(each, [new]) for each in names if each != old and each not in known)


def is_free_key(new: str, key: Located, known: Container[str] = ()) -> bool:
    """Whether a key of YAML can get a name."""
    return is_free(new, key, keys_beside(key), known)


def names_beside(name: Located) -> Counter[str]:
    """All keys or attributes of the entity of a launch file that has one; empty for what is not the name of one."""
    return keys_beside(name) if name.span.source.kind == "launch-yaml" else attributes_beside(name)


def keys_beside(key: Located | Span) -> Counter[str]:
    """All keys of the mapping of YAML that has a key; empty for what is not a key."""
    span = key.span if isinstance(key, Located) else key
    return span.source.once(keys_beside, lambda: _keys(span.source)).get(span.start, Counter())


def _keys(source: Source) -> dict[int, Counter[str]]:
    """Where the text of a key starts -> the keys of its mapping."""
    found: dict[int, Counter[str]] = {}
    for node in parse(source, follow_aliases=False).nodes:
        if isinstance(node, Mapping):
            keys = [key.value for key, _ in node.entries]
            names = Counter(map(str, keys))
            found |= {key.span.start: names for key in keys}
    return found


def attributes_beside(name: Located | Span) -> Counter[str]:
    """All attributes of the tag of XML that has an attribute; empty for what is not the name of one."""
    span = name.span if isinstance(name, Located) else name
    tag = start_tag(span.source, span.source.text.rfind("<", 0, span.start), lambda *_: None)
    attributes = tag.attributes if tag else ()
    is_attribute = any(each.name.span.start == span.start for each in attributes)
    return Counter(str(each.name) for each in attributes if is_attribute)


def elements_beside(document: Document, name: Located) -> Counter[str]:
    """All elements of the parent of an element, which its name says; empty for the root and what is not an element."""
    return _elements(document).get(name.span.start, Counter())


@lru_cache(maxsize=1)
def _elements(document: Document) -> dict[int, Counter[str]]:
    """Where the name of an element starts -> the elements of its parent, without their prefixes."""
    found: dict[int, Counter[str]] = {}
    for element in document.elements:
        names = Counter(str(child.local) for child in element.children)
        found |= {child.name.span.start: names for child in element.children}
    return found
