"""Robot descriptions that urdfdom, and with it robot_state_publisher, refuses."""

from __future__ import annotations

import re
from collections.abc import Iterator
from typing import TYPE_CHECKING

from bringup_lint.graph.memo import kept
from bringup_lint.graph.plugins.described import Described
from bringup_lint.graph.plugins.described import described
from bringup_lint.graph.plugins.described import descriptions
from bringup_lint.graph.plugins.named_descriptions import is_named
from bringup_lint.graph.plugins.named_descriptions import is_used
from bringup_lint.graph.plugins.xacro_includes import included
from bringup_lint.graph.plugins.xacro_includes import is_unconditional
from bringup_lint.named_tuple import NamedTuple
from bringup_lint.parsers.xml import parse
from bringup_lint.pattern import regex
from bringup_lint.source import Located
from bringup_lint.source import Span
from bringup_lint.spelling import WordSlips
from bringup_lint.spelling import slip_of

if TYPE_CHECKING:
    from bringup_lint.graph.files import Files
    from bringup_lint.graph.workspace import Workspace
    from bringup_lint.model.xml import Element
    from bringup_lint.source import Source

_END = regex(r"\blink[ \t]*=[ \t]*[\"'](?P<name>[^\"'<>]*)[\"']", hints="link")
_LIMITED = ("revolute", "prismatic")
_DEGREES = (30, 360)
_NEEDED = ("effort", "velocity")
_VECTORS = {"origin": ("xyz", "rpy"), "axis": ("xyz",), "box": ("size",)}
_AXES = 3
_OUTER = frozenset({"ros2_control", "transmission", "gazebo", "state", "group_state"})
"""Elements whose joints only refer to those of the robot."""


class Refused(NamedTuple):
    where: Span
    what: str
    """``no-limit``, ``no-attribute``, ``limits``, ``degrees``, ``turned``, ``no-link``, ``twice``, ``roots``,
    ``vector``, ``parents``, ``orphan`` or ``no-file``."""
    name: str
    detail: str = ""
    other: Span | None = None
    lost: Located | None = None
    """The link that no joint names, of an ``orphan``."""
    used: bool = True
    """A launch file or another description names the file."""


def refused_descriptions(files: Files, workspace: Workspace) -> Iterator[list[Refused]]:
    """What is wrong with the judged descriptions, that of one file together."""
    packages = workspace.packages
    known: Described | None = None
    for source in files.of_kind("urdf"):
        root = parse(source).root if source.judged and not source.template else None
        if root is None or root.local != "robot":
            continue
        is_part = is_named(files, source, "urdf")
        found = [
            *_includes(root, workspace),
            *_joints(root),
            *_origins(root),
            *_repeated(root, files),
            *_vectors(root),
            *(_tree(root) if _is_plain(source) and not is_part else ()),
        ]
        lost = list(_lost(root)) if "xacro" in source.text and not found else []
        if lost:
            known = known or described(files.tree, packages)
            found += (each for each in lost if known.links and not known.is_open and not known.has_link(each.name))
        if found:
            used = is_part or is_used(files, source)
            by_used = (each._replace(used=used or (each.what == "no-file" and bool(each.detail))) for each in found)
            yield sorted(by_used, key=_is_read)


def _includes(root: Element, workspace: Workspace) -> Iterator[Refused]:
    """The files that xacro includes in any case, and that the tree does not have."""
    for element in root.walk():
        name = element.get("filename") if element.name == "xacro:include" else None
        if name is None or not is_unconditional(element):
            continue
        found = included(workspace, name.span.source, name)
        if found is not None and found.file is None:
            yield Refused(name.span, "no-file", str(name), _like(workspace, name))


def _like(workspace: Workspace, filename: Located) -> str:
    """The one description of the tree whose name an include misspells."""
    return _slips(workspace).meant(filename.rpartition("/")[2]) or ""


@kept
def _slips(workspace: Workspace) -> WordSlips:
    return WordSlips(path.rpartition("/")[2] for path in descriptions(workspace.tree))


def _is_read(refused: Refused) -> bool:
    """Whether urdfdom takes the description all the same."""
    return refused.what in ("limits", "degrees", "turned", "parents")


def _is_plain(source: Source) -> bool:
    """Whether the text is the description itself, of which xacro and templates make nothing else."""
    return source.name.endswith(".urdf") and "xacro" not in source.text and "$" not in source.text


def _is_own(element: Element) -> bool:
    return not any(each.local in _OUTER for each in element.ancestors)


def _joints(root: Element) -> Iterator[Refused]:
    for joint in root.walk():
        if joint.name != "joint" or joint.get("type") is None or not _is_own(joint):
            continue
        if any(":" in child.name for child in joint.children):
            continue
        name = str(joint.get("name") or "")
        limit = joint.find("limit")
        if limit is not None:
            yield from _limit(limit, name, joint.get("type") == "revolute")
        elif joint.get("type") in _LIMITED and not any(slip_of(each.name, ("limit",)) for each in joint.children):
            yield Refused(joint.tag, "no-limit", name, str(joint.get("type")))


def _limit(limit: Element, name: str, turns: bool) -> Iterator[Refused]:
    """urdfdom reads the limits of a joint of any type."""
    if limit.children:
        return
    for attribute in _NEEDED:
        is_misspelt = any(slip_of(each.name, (attribute,)) for each in limit.attributes)
        if not limit.get(attribute) and not is_misspelt:
            yield Refused(limit.tag, "no-attribute", name, attribute)
            return
    lower, upper = _number(limit.get("lower")), _number(limit.get("upper"))
    if lower is not None and upper is not None and lower > upper:
        yield Refused(limit.tag, "limits", name, f"{limit.get('lower')} > {limit.get('upper')}")
    elif turns and any(number is not None and _is_in_degrees(number) for number in (lower, upper)):
        yield Refused(limit.tag, "degrees", name, f"{limit.get('lower')} to {limit.get('upper')}")


def _is_in_degrees(limit: float) -> bool:
    """Whether an angle is a round number of degrees, and many turns in radians."""
    return _DEGREES[0] <= abs(limit) <= _DEGREES[1] and limit % 5 == 0


def _origins(root: Element) -> Iterator[Refused]:
    """Places of joints, shapes and sensors that are turned by degrees."""
    for origin in root.walk():
        angles = origin.get("rpy") if origin.name == "origin" else None
        numbers = [_number(each) for each in angles.split()] if angles is not None else []
        if angles is not None and any(each is not None and _is_in_degrees(each) for each in numbers):
            outer = origin.parent
            name = (outer.get("name") if outer is not None else None) or ""
            yield Refused(angles.span, "turned", str(name), str(angles))


def _number(text: str | None) -> float | None:
    try:
        return float(text) if text is not None else None
    except ValueError:
        return None


def _tree(root: Element) -> Iterator[Refused]:
    links = [each for each in root.find_all("link") if each.get("name") is not None]
    joints = [each for each in root.find_all("joint") if each.get("name") is not None]
    names = {str(each.get("name")) for each in links}
    children = set()
    for joint in joints:
        for end in ("parent", "child"):
            found = joint.find(end)
            link = found.get("link") if found is not None else None
            if link is not None and str(link) not in names:
                yield Refused(link.span, "no-link", str(link), str(joint.get("name")))
            if link is not None and end == "child":
                children.add(str(link))
    roots = [each for each in links if str(each.get("name")) not in children]
    if len(roots) > 1:
        yield Refused(roots[1].tag, "roots", str(roots[1].get("name")), str(roots[0].get("name")), roots[0].tag)


def _lost(root: Element) -> Iterator[Refused]:
    """Links that joints outside of macros and conditions name, and that the file itself does not make."""
    own = {str(each.get("name")) for each in root.find_all("link")}
    for joint in root.find_all("joint"):
        ends = [found.get("link") for end in ("parent", "child") if (found := joint.find(end)) is not None]
        links = [link for link in ends if link is not None and "$" not in link]
        lost = [link for link in links if str(link) not in own]
        if joint.get("type") and len(links) == 2 and len(lost) == 1:
            yield Refused(lost[0].span, "no-link", str(lost[0]), str(joint.get("name")))


def _vectors(root: Element) -> Iterator[Refused]:
    """Attributes of three numbers that urdfdom does not take for that: it splits at blanks alone."""
    for element in root.walk():
        for attribute in _VECTORS.get(element.name, ()):
            value = element.get(attribute)
            if value is None or "$" in value or not _is_own(element):
                continue
            numbers = [_number(each) for each in value.split()]
            if len(numbers) != _AXES or None in numbers:
                yield Refused(value.span, "vector", f"{element.name} {attribute}", str(value))


def _repeated(root: Element, files: Files) -> Iterator[Refused]:
    """What the description itself, or one macro, has twice under one literal name."""
    for scope in (root, *(each for each in root.walk() if each.name == "xacro:macro")):
        for kind in ("link", "joint"):
            yield from _twice(kind, [each for each in scope.find_all(kind) if _is_literal(each.get("name"))])
        placed: dict[str, Element] = {}
        for joint in (each for each in scope.find_all("joint") if _is_literal(each.get("name"))):
            child = joint.find("child")
            link = child.get("link") if child is not None else None
            if link is None or not _is_literal(link):
                continue
            first = placed.setdefault(str(link), joint)
            if first.get("name") != joint.get("name"):
                names = f"{first.get('name')}, {joint.get('name')}"
                lost = _orphan(scope, [each.text for each in files.of_kind("urdf")])
                yield Refused(link.span, "orphan" if lost else "parents", str(link), names, first.tag, lost)


def _orphan(scope: Element, texts: list[str]) -> Located | None:
    """A link that no joint of the tree names: for urdfdom it is a second root."""
    ends = [match["name"] for text in texts for match in _END.finditer(text)]
    for link in scope.find_all("link"):
        name = link.get("name")
        if name is not None and _is_literal(name) and not any(_may_be(end, name, texts) for end in ends):
            return name
    return None


def _may_be(end: str, name: str, texts: list[str]) -> bool:
    """Whether the end of a joint is a link, as soon as xacro has put in a value that the descriptions have."""
    start, dollar, rest = end.partition("$")
    rest = rest.rpartition("}")[2]
    if not dollar or not name.startswith(start) or not name[len(start) :].endswith(rest):
        return end == name
    value = re.escape(name[len(start) : len(name) - len(rest)])
    given = re.compile(rf"(?<!<link name=)[\"']{value}[\"']")
    return any(given.search(text) for text in texts)


def _is_literal(name: str | None) -> bool:
    return name is not None and "$" not in name


def _twice(kind: str, elements: list[Element]) -> Iterator[Refused]:
    first: dict[str, Element] = {}
    for each in elements:
        name = str(each.get("name"))
        if name in first:
            yield Refused(each.tag, "twice", name, kind, first[name].tag)
        first.setdefault(name, each)
