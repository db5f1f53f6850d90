"""Links and joints that the SRDF of a robot names, and that its description does not have."""

from __future__ import annotations

from collections.abc import Collection
from collections.abc import Iterator
from typing import TYPE_CHECKING

from bringup_lint.graph.plugins.described import Described
from bringup_lint.graph.plugins.described import described
from bringup_lint.graph.plugins.described import descriptions
from bringup_lint.graph.plugins.described import included_from
from bringup_lint.graph.plugins.described import included_names
from bringup_lint.named_tuple import NamedTuple
from bringup_lint.parsers.xml import parse
from bringup_lint.spelling import nearest

if TYPE_CHECKING:
    from bringup_lint.discover.tree import Tree
    from bringup_lint.model.xml import Element
    from bringup_lint.source import Located

_ENDING = ".srdf"
_LINKS = {
    ("chain", "base_link"),
    ("chain", "tip_link"),
    ("link", "name"),
    ("end_effector", "parent_link"),
    ("virtual_joint", "child_link"),
}
_JOINTS = {("joint", "name"), ("passive_joint", "name")}
"""Elements and attributes of an SRDF. Source: srdfdom, model.cpp."""
_KNOWN = 3
"""Names of an SRDF that the description has, where it is that of the same robot."""


class UnknownName(NamedTuple):
    name: Located
    kind: str
    """``link`` or ``joint``."""
    described: Located
    """The name of the robot in its description."""
    near: str | None
    others: tuple[Located, ...]
    """More names of the same file."""


def unknown_names(tree: Tree, packages: Collection[str]) -> Iterator[UnknownName]:
    """The names of each file together, where one description of the tree has the name of its robot, and most of what
    the file names."""
    files = [path for path in tree.paths if path.endswith(_ENDING)]
    models = dict(_models(tree)) if files else {}
    known: dict[Located, Described] = {}
    for path in files:
        source = tree.at(path)
        root = parse(source).root if source is not None and source.judged and not source.template else None
        model = models.get(str(root.get("name"))) if root is not None else None
        if root is None or model is None:
            continue
        if model not in known:
            known[model] = described(tree, packages, included_from(tree, [model.span.source.absolute]))
        if not known[model].is_open:
            yield from _of_file(root, known[model], model)


def _models(tree: Tree) -> Iterator[tuple[str, Located]]:
    """The names of robots that one description has which is no part of another one."""
    found: dict[str, list[Located]] = {}
    parts = included_names(tree)
    for path in (each for each in descriptions(tree) if each.rpartition("/")[2] not in parts):
        source = tree.at(path)
        root = parse(source).root if source is not None and not source.template else None
        name = root.get("name") if root is not None and root.name == "robot" else None
        if name is not None and "$" not in name:
            found.setdefault(str(name), []).append(name)
    return ((name, places[0]) for name, places in found.items() if len(places) == 1)


def _of_file(root: Element, known: Described, model: Located) -> Iterator[UnknownName]:
    made = {str(each.get("name")) for each in root.find_all("virtual_joint")}
    named = [each for each in _named(root) if "$" not in each[0] and str(each[0]) not in made]
    unknown = [each for each in named if not _has(known, *each)]
    if not unknown or len(named) - len(unknown) < max(_KNOWN, len(unknown)):
        return
    (name, kind), *others = unknown
    near = nearest(name, known.links if kind == "link" else known.joints, 3)
    yield UnknownName(name, kind, model, near[0] if len(near) == 1 else None, tuple(each for each, _ in others))


def _has(known: Described, name: Located, kind: str) -> bool:
    return known.has_link(str(name)) if kind == "link" else known.has(str(name))


def _named(root: Element) -> Iterator[tuple[Located, str]]:
    for element in root.walk():
        for kind, places in (("link", _LINKS), ("joint", _JOINTS)):
            for local, attribute in places:
                value = element.get(attribute) if element.local == local else None
                if value is not None:
                    yield value, kind
