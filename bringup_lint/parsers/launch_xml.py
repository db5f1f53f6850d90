"""XML launch files."""

from __future__ import annotations

from bringup_lint.model.launch import LaunchFile
from bringup_lint.model.launch_tag import Tag
from bringup_lint.model.launch_tag import Written
from bringup_lint.model.xml import Element
from bringup_lint.parsers import xml
from bringup_lint.parsers.launch_frontend.actions import Builder
from bringup_lint.parsers.launch_frontend.entity import Attribute
from bringup_lint.parsers.launch_frontend.entity import Entity
from bringup_lint.pattern import regex
from bringup_lint.source import Located
from bringup_lint.source import Problem
from bringup_lint.source import Source

DEPTH = 60
_LINES = regex(r"\r\n|[\t\r\n]")


def parse(source: Source) -> LaunchFile:
    """The launch file's actions in order; ``problems`` are those of the XML, and ``no-launch-root``."""
    document = xml.parse(source)
    file = LaunchFile(source, "xml", problems=list(document.problems))
    root = document.root
    if root is None:
        return file
    if root.local != "launch":
        file.problems.append(Problem("no-launch-root", root.name))
        return file
    file.entry = root.tag
    file.tag = tag(root)
    file.actions = Builder(file).actions(entity(child, 0) for child in root.children)
    document.let_go()
    return file


def entity(element: Element, depth: int) -> Entity:
    attributes: dict[str, Attribute] = {str(attribute.name): attribute.value for attribute in element.attributes}
    children = [] if depth > DEPTH else [entity(child, depth + 1) for child in element.children]
    keys = {str(attribute.name): attribute.name for attribute in element.attributes}
    return Entity(element.name, element.tag, attributes, children, keys)


def tag(element: Element, depth: int = 0) -> Tag:
    """The element as it is written."""
    inside: list[Tag] = []
    result = Tag(element.name, element.tag, actions=inside)
    for attribute in element.attributes:
        text = _blanks(attribute.value)
        result.attributes[str(attribute.name)] = Written(attribute.name, text, str(text))
    if depth > DEPTH:
        return result
    for child in element.children:
        inner = tag(child, depth + 1)
        inside.append(inner)
        result.lists.setdefault(str(child.name), []).append(inner)
        result.keys.setdefault(str(child.name), child.name)
    return result


def _blanks(value: Located) -> Located:
    """XML makes a blank of every tab and line end in an attribute, except of those that are written as references."""
    if "&#" in value.span.text or not _LINES.search(value):
        return value
    return Located(_LINES.sub(" ", value), value.span)
