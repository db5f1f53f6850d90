"""YAML launch files: lists of maps with one key, the tag."""

from __future__ import annotations

from bringup_lint.model.launch import LaunchFile
from bringup_lint.model.yaml_node import Mapping
from bringup_lint.model.yaml_node import Node
from bringup_lint.model.yaml_node import Scalar
from bringup_lint.model.yaml_node import Sequence
from bringup_lint.parsers import yaml_nodes
from bringup_lint.parsers.launch_frontend.actions import Builder
from bringup_lint.parsers.launch_frontend.entity import Entity
from bringup_lint.source import Located
from bringup_lint.source import Problem
from bringup_lint.source import Source

DEPTH = 60


def parse(source: Source) -> LaunchFile:
    """The launch file's actions in order; ``problems`` are those of the YAML, and ``no-launch-root``."""
    document = yaml_nodes.parse(source)
    file = LaunchFile(source, "yaml", problems=list(document.problems))
    root = document.root
    found = root.entry("launch") if isinstance(root, Mapping) else None
    if found is None:
        if not file.problems:
            file.problems.append(Problem("no-launch-root", source.whole if root is None else root.span))
        return file
    key, body = found
    file.entry = key.span
    if isinstance(body, Sequence):
        file.actions = Builder(file).actions(entities(body, 0))
    return file


def entities(body: Sequence, depth: int) -> list[Entity]:
    """The items of a list: each a map of one tag."""
    if depth > DEPTH:
        return []
    return [
        entity(key.value, value, depth)
        for item in body.items
        if isinstance(item, Mapping)
        for key, value in list(item.entries)[:1]
    ]


def entity(tag: Located, value: Node, depth: int) -> Entity:
    result = Entity(tag, tag.span)
    if isinstance(value, Sequence):
        result.children = entities(value, depth + 1)
    elif isinstance(value, Mapping):
        _fill(result, value, depth)
    return result


def _fill(result: Entity, body: Mapping, depth: int) -> None:
    for key, value in body.entries:
        if isinstance(value, Scalar):
            result.attributes[str(key.value)] = value.value
        elif isinstance(value, Sequence):
            _fill_list(result, key.value, value, depth)


def _fill_list(result: Entity, key: Located, value: Sequence, depth: int) -> None:
    if key == "children":
        result.children += entities(value, depth + 1)
    elif any(isinstance(item, Mapping) for item in value.items):
        if depth <= DEPTH:
            result.children += [entity(key, item, depth + 1) for item in value.items if isinstance(item, Mapping)]
    else:
        result.attributes[str(key)] = [item.value for item in value.scalars]
