"""Filters and drive controllers that publish a link which every robot description of the tree puts below another."""

from __future__ import annotations

from collections.abc import Iterator
from itertools import chain
from typing import TYPE_CHECKING

from bringup_lint.discover.kinds.launch import LAUNCH
from bringup_lint.graph.launch.started import literal_text
from bringup_lint.graph.topics.questions.apart import are_together
from bringup_lint.graph.topics.questions.transform_files import drives
from bringup_lint.graph.topics.questions.transform_files import filters
from bringup_lint.named_tuple import NamedTuple
from bringup_lint.parsers.xml import parse
from bringup_lint.pattern import regex

if TYPE_CHECKING:
    from bringup_lint.graph.topics.questions.transform_sources import TransformSource
    from bringup_lint.graph.topics.topics import Topics
    from bringup_lint.model.xml import Element
    from bringup_lint.source import Located
    from bringup_lint.source import Source
    from bringup_lint.source import Span

_PREFIX = regex(r"frame_prefix|tf_prefix")
_CHOOSING = ("if", "unless")
_CHILD = ("base_link_frame_output", "base_link_frame")


class TwoParents(NamedTuple):
    source: TransformSource
    where: Span
    """Where the link is named."""
    parent: Located
    """The other one, in the description."""


def two_parents(topics: Topics) -> Iterator[TwoParents]:
    """Each once. Silent where a prefix is given to frames, and where a description leaves a part of the names open."""
    publishers = (node for node in topics.launch.nodes if literal_text(node.package) == "robot_state_publisher")
    if not any(publishers) or any(source.matches(_PREFIX) for source in topics.files.of_kind(*LAUNCH)):
        return
    of_filters = (
        (source, next((given.values[key].where for key in _CHILD if key in given.values), source.where))
        for _, given, source in filters(topics)
    )
    of_drives = ((each, each.where) for _, found in drives(topics) for each in found)
    sources = topics.files.of_kind("urdf")
    roots = [(each, root) for each in sources if (root := parse(each).root) is not None]
    said: set[Span] = set()
    for source, where in chain(of_filters, of_drives):
        parent = _parent(topics, roots, source) if where not in said else None
        if parent is not None:
            said.add(where)
            yield TwoParents(source, where, parent)


def _parent(topics: Topics, roots: list[tuple[Source, Element]], source: TransformSource) -> Located | None:
    """The link above the one that is published, where all descriptions that hold it fix it below one that is not the
    frame of the odometry."""
    found: list[Located] = []
    for description, root in roots:
        if source.child not in description.text or not _has_link(root, source.child):
            continue
        above = list(_above(root, source.child))
        if len(above) != 1 or above[0] == source.parent or not _are_started(topics, description, source.where.source):
            return None
        found += above
    return found[0] if found else None


def _are_started(topics: Topics, description: Source, other: Source) -> bool:
    """Whether one robot has both: they lie in one package, or one launch file starts a robot_state_publisher with the
    package of the description, and what reads the other file."""
    workspace = topics.launch.workspace
    owner = workspace.owner(description)
    if owner is None or owner is workspace.owner(other):
        return are_together(topics, description, other)
    for expansion in topics.launch.expansions:
        nodes = [each for each in expansion.nodes if literal_text(each.package) == "robot_state_publisher"]
        files = [each.file.source for each in nodes]
        if any(workspace.owner(file) is owner or str(owner.name) in file.text for file in files):
            if any(file.source is other or other.basename in file.source.text for file in expansion.files):
                return True
    return False


def _has_link(root: Element, name: str) -> bool:
    """Whether a description has a link of this name, or may have one."""
    names = (str(each.get("name")) for each in root.walk() if each.local == "link")
    return any(each == name or ("$" in each and each.endswith(name)) for each in names)


def _above(root: Element, link: str) -> Iterator[Located]:
    """The parents of a link by fixed joints that no condition chooses."""
    for each in root.walk():
        if each.local == "joint" and each.get("type") == "fixed" and not _is_chosen(each):
            ends = {str(end.local): end.get("link") for end in each.children}
            parent = ends.get("parent")
            if ends.get("child") == link and parent is not None and "$" not in parent:
                yield parent


def _is_chosen(element: Element) -> bool:
    """Whether a condition of xacro decides about an element."""
    return any(each.local in _CHOOSING for each in element.ancestors)
