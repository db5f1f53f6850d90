"""Misspelt elements, attributes and types of robot descriptions, which their readers skip."""

from __future__ import annotations

from collections.abc import Iterator
from functools import cache
from typing import TYPE_CHECKING

from bringup_lint.facts import table
from bringup_lint.graph.plugins.named_descriptions import is_used
from bringup_lint.graph.plugins.unread_descriptions import refused_xml
from bringup_lint.named_tuple import NamedTuple
from bringup_lint.parsers.xml import parse
from bringup_lint.source import Located
from bringup_lint.spelling import WordSlips

if TYPE_CHECKING:
    from bringup_lint.graph.files import Files
    from bringup_lint.model.xml import Element

_NEEDED = {
    "inertial": ("mass", "inertia"),
    "mass": ("value",),
    "inertia": ("ixx", "ixy", "ixz", "iyy", "iyz", "izz"),
    "visual": ("geometry",),
    "collision": ("geometry",),
    "geometry": ("box", "cylinder", "sphere", "mesh"),
    "box": ("size",),
    "cylinder": ("radius", "length"),
    "sphere": ("radius",),
    "mesh": ("filename",),
    "link": ("name",),
    "joint": ("name", "type", "parent", "child"),
    "parent": ("link",),
    "child": ("link",),
    "mimic": ("joint",),
    "limit": ("effort", "velocity"),
}
"""Without which urdfdom refuses the element, and with it the description."""
_LIMITED = ("revolute", "prismatic")
_TYPES = {
    "joint": frozenset(("revolute", "continuous", "prismatic", "fixed", "floating", "planar")),
    "ros2_control": frozenset(("system", "actuator", "sensor")),
}


class MisspeltWord(NamedTuple):
    where: Located
    what: str
    """``element``, ``attribute`` or ``type``."""
    outer: str
    """The element around it, or the one that it belongs to."""
    near: str
    by: str
    """Who skips it: ``urdfdom``, ``ros2_control`` or ``Gazebo``."""
    fatal: bool
    """The whole description is refused."""
    used: bool = True
    """A launch file or another description names the file."""


def misspelt_words(files: Files) -> Iterator[MisspeltWord]:
    """Those of all judged descriptions."""
    for source in files.of_kind("urdf"):
        root = parse(source).root if source.judged and not source.template else None
        found = list(_below(root)) if root is not None and refused_xml(source) is None else []
        used = bool(found) and is_used(files, source)
        yield from (each._replace(used=used) for each in found)


@cache
def _grammar() -> dict[tuple[str, str], tuple[frozenset[str], frozenset[str]]]:
    """Part and element -> attributes and children."""
    return {
        (row["part"], row["element"]): (frozenset(row["attributes"].split()), frozenset(row["children"].split()))
        for row in table("ros/description_grammar")
    }


@cache
def _slips(known: frozenset[str]) -> WordSlips:
    return WordSlips(known)


def _below(root: Element) -> Iterator[MisspeltWord]:
    """What is misspelt in a description, by the part of the grammar that holds for each element."""
    pending = [(root, "urdf")]
    while pending:
        element, part = pending.pop()
        if element.name in ("gazebo", "ros2_control"):
            part = str(element.name)
        if element.name == "plugin":
            continue
        if ":" not in element.name:
            yield from _of_element(element, part)
        pending += ((child, part) for child in reversed(element.children))


def _of_element(element: Element, part: str) -> Iterator[MisspeltWord]:
    name = _name(element)
    attributes, children = _grammar().get((part, name), (frozenset[str](), frozenset[str]()))
    by = {"urdf": "urdfdom", "gazebo": "Gazebo"}.get(part, part)
    outer = str(element.name)
    given = {str(each.name) for each in element.attributes}
    inside = {str(each.name) for each in element.children}
    for child in element.children:
        if children and child.name not in children and ":" not in child.name:
            near = _slips(children).meant(child.name)
            if near is not None:
                needed = (*_NEEDED.get(outer, ()), "limit" if element.get("type") in _LIMITED else "")
                fatal = part == "urdf" and near in needed and near not in inside
                yield MisspeltWord(child.name, "element", outer, near, by, fatal)
    for attribute in element.attributes:
        if attributes and attribute.name not in attributes and ":" not in attribute.name:
            near = _slips(attributes).meant(attribute.name)
            if near is not None and near not in given:
                fatal = part == "urdf" and near in _NEEDED.get(outer, ())
                yield MisspeltWord(attribute.name, "attribute", outer, near, by, fatal)
    kind = element.get("type")
    types = _TYPES.get(name) if part != "gazebo" and (name == "ros2_control") == (part == "ros2_control") else None
    if kind is not None and types is not None and "$" not in kind and kind not in types:
        near = _slips(types).meant(kind)
        if near is not None:
            yield MisspeltWord(kind, "type", outer, near, by, part == "urdf")


def _name(element: Element) -> str:
    """The name of an element in the grammar, where joints of transmissions have another one."""
    outer = element.parent
    if outer is not None and outer.name == "transmission":
        return f"transmission/{element.name}"
    return str(element.name)
