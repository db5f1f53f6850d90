"""What catkin_pkg, with which colcon, rosdep and ament read package.xml, refuses (catkin_pkg 1.1, ``package.py``)."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterator

from bringup_lint.model.xml import Document
from bringup_lint.model.xml import Element
from bringup_lint.pattern import regex
from bringup_lint.source import Problem

_UNSURE = frozenset(
    "doctype encoding entity too-large too-deep too-many-problems empty-document control-character".split()
)
"""What our own reader says of texts that expat may read."""
_LENIENT = regex(r"<\?xml\s+version\s*=\s*(?:\"[\w.:-]+\"|'[\w.:-]+')[^<>]*\?>")
"""A declaration with a version that expat does not look at."""
_VERSIONS = tuple(f"version_{each}" for each in ("lt", "lte", "eq", "gte", "gt"))
_ONCE = ("name", "version", "description")
_ALWAYS: dict[str, tuple[str, ...]] = {
    **{"name": (), "version": ("compatibility",), "description": (), "maintainer": ("email",), "license": ()},
    **{"url": ("type",), "author": ("email",), "export": ()},
    **dict.fromkeys(("build_depend", "buildtool_depend", "test_depend", "conflict", "replace"), _VERSIONS),
}
"""Tag -> its attributes."""
_SECOND = dict.fromkeys(
    ("build_export_depend", "buildtool_export_depend", "depend", "exec_depend", "doc_depend"), _VERSIONS
)
_THIRD = {"group_depend": (), "member_of_group": (), "license": ("file",)}
_CONDITIONAL = ("depend", "conflict", "replace", "member_of_group")
_INCLUDES: dict[bool, dict[str, tuple[str, ...]]] = {
    True: {"test_depend": ("build_depend", "run_depend")},
    False: {"depend": ("build_depend", "build_export_depend", "exec_depend")},
}
"""Whether it is the first format -> tag -> the tags that say the same again."""
_NAME = regex(r"[a-zA-Z0-9][a-zA-Z0-9_-]*\Z")
_VERSION = regex(r"[0-9]+\.[0-9]+\.[0-9]+\Z")
_EMAIL = regex(r"[-a-zA-Z0-9_%+]+(?:\.[-a-zA-Z0-9_%+]+)*@[-a-zA-Z0-9%]+(?:\.[-a-zA-Z0-9%]+)*\.[a-zA-Z]{2,}\Z")
_OPEN = regex(r"\{\{|\{%|<%|@[A-Za-z_]+@|@\(")
"""What a template leaves to be filled in."""


def tags_of_format(form: int) -> dict[str, tuple[str, ...]]:
    """The tags of a format, each with its attributes."""
    tags = {**_ALWAYS, **({"run_depend": _VERSIONS} if form == 1 else _SECOND), **(_THIRD if form > 2 else {})}
    if form < 3:
        return tags
    return {tag: (*names, "condition") if tag.endswith(_CONDITIONAL) else names for tag, names in tags.items()}


def refused(document: Document) -> Iterator[Problem]:
    """What stops the reader. The detail says it in words, or gives the name that a tag or attribute should have."""
    root = document.root
    if root is None or _OPEN.search(document.source.text):
        return
    broken = next((each for each in document.problems if each.code not in _UNSURE), None)
    if broken is not None and broken.code == "bad-declaration" and _LENIENT.match(document.source.text):
        return
    if broken is not None:
        yield Problem("not-well-formed", broken.span, broken.detail)
        return
    if root.name != "package":
        yield Problem("root", root.name.span, str(root.name))
        return
    if any(each.code in _UNSURE for each in document.problems):
        return
    written = root.get("format")
    if written is not None and written.strip() not in ("1", "2", "3"):
        yield Problem("format", written.span, str(written))
        return
    form = int(written or 1)
    yield from _of_attributes(root, ("format",))
    yield from _of_tags(root, tags_of_format(form))
    yield from _of_numbers(root)
    yield from _of_values(root)
    yield from _of_repetitions(root, form)


def _of_attributes(element: Element, known: tuple[str, ...]) -> Iterator[Problem]:
    for attribute in element.attributes:
        if attribute.name not in (*known, "xmlns") and ":" not in attribute.name:
            yield Problem("attribute", attribute.name.span, str(element.name))


def _of_tags(root: Element, known: dict[str, tuple[str, ...]]) -> Iterator[Problem]:
    for element in root.children:
        if element.name not in known:
            yield Problem("tag", element.name.span, str(element.name))
            continue
        yield from _of_attributes(element, known[str(element.name)])
        if element.children and element.name not in ("description", "export"):
            yield Problem("child", element.children[0].name.span, str(element.name))


def _of_numbers(root: Element) -> Iterator[Problem]:
    """Tags that are needed, and tags that may be there only once."""
    counts = Counter(str(element.name) for element in root.children)
    for tag in (*_ONCE, "maintainer", "license"):
        if not counts[tag]:
            yield Problem("missing", root.name.span, tag)
    for tag in (*_ONCE, "export"):
        if counts[tag] > 1:
            second = [element for element in root.children if element.name == tag][1]
            yield Problem("twice", second.name.span, tag)


def _of_values(root: Element) -> Iterator[Problem]:
    name = next((str(element.text) for element in root.children if element.name == "name"), "")
    for element in root.children:
        tag, text = str(element.name), element.text
        if "$" in text:
            continue
        if tag in ("name", "version", "description", "license") and _is_empty(element):
            yield Problem("empty", element.tag, tag)
        elif tag == "name" and not _NAME.match(text):
            yield Problem("name", text.span, str(text))
        elif tag == "version" and not _VERSION.match(text):
            yield Problem("version", text.span, str(text))
        elif tag in ("maintainer", "author"):
            yield from _of_person(element, tag)
        elif tag.endswith("depend") and tag != "group_depend" and text == name:
            yield Problem("itself", text.span, tag)


def _is_empty(element: Element) -> bool:
    """A description may hold other elements, and comments."""
    if element.name != "description":
        return not element.text
    inside = element.span.source.text[element.tag.end : element.span.end].rpartition("</")[0]
    return not inside.strip()


def _of_person(element: Element, tag: str) -> Iterator[Problem]:
    email = element.get("email")
    if email is None:
        if tag == "maintainer":
            yield Problem("no-email", element.tag, tag)
    elif not _EMAIL.match(email):
        yield Problem("email", email.span, str(email))


def _of_repetitions(root: Element, form: int) -> Iterator[Problem]:
    """Dependencies that another one with the same attributes includes."""
    includes: dict[str, tuple[str, ...]] = _INCLUDES[form == 1]
    given: dict[tuple[str, ...], Element] = {}
    for element in (each for each in root.children if each.name.endswith("depend")):
        key = (str(element.name), *_dependency(element))
        if key in given and element.name == "depend":
            yield Problem("redundant", element.text.span, "depend")
        given.setdefault(key, element)
    for tag, *what in given:
        for other in includes.get(tag, ()):
            same = given.get((other, *what))
            if same is not None:
                yield Problem("redundant", same.text.span, tag)


def _dependency(element: Element) -> tuple[str, ...]:
    return (str(element.text), *sorted(f"{each.name}={each.value}" for each in element.attributes))
