"""XML launch files."""

from __future__ import annotations

from bringup_lint.model.launch import LaunchFile
from bringup_lint.model.xml import Element
from bringup_lint.parsers import xml
from bringup_lint.parsers.launch_frontend.actions import Builder
from bringup_lint.parsers.launch_frontend.entity import Entity
from bringup_lint.source import Problem
from bringup_lint.source import Source

DEPTH = 60


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
    file.actions = Builder(file).actions(entity(child, 0) for child in root.children)
    return file


def entity(element: Element, depth: int) -> Entity:
    attributes = {str(attribute.name): attribute.value for attribute in element.attributes}
    children = [] if depth > DEPTH else [entity(child, depth + 1) for child in element.children]
    keys = {str(attribute.name): attribute.name for attribute in element.attributes}
    return Entity(element.name, element.tag, attributes, children, keys)
