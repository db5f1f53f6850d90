"""YAML launch files: lists of maps with one key, the tag."""

from __future__ import annotations

from bringup_lint.model.launch import LaunchFile
from bringup_lint.model.launch_tag import Tag
from bringup_lint.model.launch_tag import Written
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
    file.tag = tag(key.value, body)
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


def tag(name: Located, value: Node, depth: int = 0) -> Tag:
    """The value under a key as it is written."""
    result = Tag(name, name.span, form="map")
    if depth > DEPTH:
        result.problems.append(Problem("too-deep", name))
    elif isinstance(value, Sequence):
        result.form = "list"
        result.actions = _actions(result, value, depth)
    elif isinstance(value, Mapping):
        for key, inner in value.merged:
            _attribute(result, key.value, inner, depth)
    else:
        result.problems.append(Problem("no-map", name))
    return result


def _attribute(result: Tag, key: Located, value: Node, depth: int) -> None:
    if key == "children":
        result.actions = _actions(result, value, depth)
    elif isinstance(value, Sequence) and (not value.items or isinstance(value.items[0], Mapping)):
        result.keys[str(key)] = key
        result.lists[str(key)] = [tag(key, item, depth + 1) for item in value.items]
        if not value.items:
            result.attributes[str(key)] = Written(key, Located("", value.span), [])
    else:
        result.attributes[str(key)] = Written(key, _text(value), plain(value))


def _actions(result: Tag, value: Node, depth: int) -> list[Tag]:
    found = []
    items = value.items if isinstance(value, Sequence) else ()
    if not isinstance(value, Sequence):
        result.problems.append(Problem("not-a-list", value.span))
    for item in items:
        if not isinstance(item, Mapping) or len(item.pairs) != 1:
            many = isinstance(item, Mapping) and len(item.pairs) > 1
            result.problems.append(Problem("several-keys" if many else "no-map", item.span))
        found += [tag(key.value, inner, depth + 1) for key, inner in getattr(item, "entries", ())]
    return found


def _text(value: Node) -> Located:
    return value.value if isinstance(value, Scalar) else Located("", value.span)


def plain(value: Node) -> object:
    """What YAML makes of a value: a scalar of Python, a list of them, or the node itself when it is anything else."""
    if isinstance(value, Sequence):
        items = [plain(item) for item in value.items]
        return value if any(isinstance(item, (Mapping, Sequence)) for item in items) else items
    if not isinstance(value, Scalar):
        return value
    if value.style or value.tag:
        return str(value.value)
    return resolved(str(value.value))


def resolved(text: str) -> object:
    """A plain scalar as YAML 1.1 types it; the text itself when it is none."""
    import yaml

    try:
        return yaml.safe_load(text)
    except (yaml.YAMLError, ValueError, RecursionError, OverflowError):
        return text
