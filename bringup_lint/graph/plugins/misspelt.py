"""Names of frames, joints and hardware that nothing else of the tree has, beside one that differs in a letter."""

from __future__ import annotations

import re
from collections import Counter
from collections.abc import Iterator
from typing import TYPE_CHECKING

from bringup_lint.endings import CPP
from bringup_lint.graph.params.values import items
from bringup_lint.graph.plugins.described import Described
from bringup_lint.graph.plugins.described import described
from bringup_lint.named_tuple import NamedTuple
from bringup_lint.parsers.xml import parse
from bringup_lint.pattern import regex
from bringup_lint.source import Span
from bringup_lint.spelling import WordSlips

if TYPE_CHECKING:
    from bringup_lint.discover.tree import Tree
    from bringup_lint.graph.files import Files
    from bringup_lint.graph.params.params import Params
    from bringup_lint.graph.workspace import Workspace
    from bringup_lint.model.xml import Element
    from bringup_lint.source import Source

_OF_FRAME = regex(r"frame|joint|link|wheel|(?<![a-z])leg", re.IGNORECASE)
"""Parameters that name frames or joints."""
_USUAL = {"map", "odom", "base_link", "base_footprint"}
"""The frames of REP 105."""
_INTERFACES = ("position", "velocity", "effort", "acceleration")
"""hardware_interface_type_values.hpp"""
_PLAIN = regex(r"/?[A-Za-z][\w.-]{3,80}\Z")
_LITERAL = regex(r"[\"']([A-Za-z]\w{4,60})[\"']")
_HOLE = regex(r"\$\{[^{}]*\}|\$\([^()]*\)")
_ASKED = regex(r"(?:parameters|get_param|Interface)[^;\n]*\Z")
"""What reads a parameter, or exports an interface."""
_BEFORE = 100
_NAMING = (*CPP, ".c", ".ino", ".rs", ".py", ".sh", ".lua", ".xml", ".yaml", ".yml", ".xacro", ".urdf", ".sdf", ".json")
"""Files that may make what has a name, or give the name to what makes it."""
_MOST = 5000
"""Files that are looked through."""
_SUSPECTS = 30
"""Names of one tree for which they are looked through."""


class Misspelt(NamedTuple):
    name: str
    where: Span
    kind: str
    """``frame`` in a parameter file, ``link`` or ``joint`` in a description, ``hardware`` in its ros2_control, or
    ``code`` for what the source of hardware reads or exports."""
    near: str
    known: Span | None
    """Where the other name is."""
    is_weak: bool = False
    """The other name counts only where several places have it."""


class _Names:
    """Names of one kind, with a place of each and how often it is named."""

    def __init__(self) -> None:
        self.places: dict[str, Span | None] = {}
        self.count: Counter[str] = Counter()

    def add(self, name: str, place: Span | None, count: int = 1) -> None:
        if self.places.get(name) is None:
            self.places[name] = place
        self.count[name] += count


def misspelt_names(files: Files, params: Params, workspace: Workspace) -> Iterator[Misspelt]:
    """Each name that only one place of the tree has, and that is a slip of exactly one other name of its kind."""
    suspects = list(_suspects(files, params, workspace))[:_SUSPECTS]
    count = _counted(files.tree, {name for each in suspects for name in (each.name, each.near)}) if suspects else {}
    said: set[frozenset[str]] = set()
    for each in suspects:
        both = frozenset((each.name, each.near))
        if count[each.name] == 1 and (count[each.near] > 1 or not each.is_weak) and both not in said:
            said.add(both)
            yield each


def _suspects(files: Files, params: Params, workspace: Workspace) -> Iterator[Misspelt]:
    roots = [(each, parse(each).root) for each in files.of_kind("urdf") if not each.template]
    elements = [(source, each) for source, root in roots if root is not None for each in root.walk()]
    links, joints, hardware = _Names(), _Names(), _Names()
    for usual in _USUAL:
        links.add(usual, None, 2)
    for _, element in elements:
        name = element.get("name")
        if name is not None and element.local in ("link", "joint"):
            (links if element.local == "link" else joints).add(str(name), name.span, 2)
        elif name is not None and element.local in ("param", "command_interface", "state_interface", "gpio", "sensor"):
            hardware.add(_HOLE.sub("", name), name.span)
    known = described(files.tree, workspace.packages) if elements else Described()
    yield from _of_descriptions(elements, known, links, joints)
    for joint, place in joints.places.items():
        links.add(joint, place, 2)
    yield from _of_files(files, params, known, links)
    if any("ros2_control" in source.text for source, _ in roots):
        yield from _of_hardware(files, elements, hardware)


def _of_files(files: Files, params: Params, known: Described, names: _Names) -> Iterator[Misspelt]:
    uses, same = [], dict[str, set[str]]()
    for _, each in params.parameters:
        if _OF_FRAME.search(each.name):
            for item in items(each):
                if isinstance(item.data, str) and _PLAIN.match(item.text):
                    name = item.text.lstrip("/")
                    names.add(name, item.span)
                    uses.append((name, item.span, each.name))
                    same.setdefault(each.name, set()).add(name)
    lonely = [use for use in uses if names.count[use[0]] == 1 and not known.has_link(use[0]) and not known.has(use[0])]
    if lonely:
        for source in files.of_kind("cpp-node", "python-node"):
            for match in _LITERAL.finditer(source.text):
                if _OF_FRAME.search(match[1]):
                    names.add(match[1], source.span(*match.span(1)), 2)
    likely = {name for name, count in names.count.items() if count > 1}
    slips, beside = (
        WordSlips(likely),
        {name: WordSlips(same[name]) for name in {parameter for _, _, parameter in lonely}},
    )
    for name, span, parameter in lonely:
        near = slips.meant(name) or beside[parameter].among_own(name)
        if near is not None:
            yield Misspelt(name, span, "frame", near, names.places[near], near not in likely)


def _of_descriptions(
    elements: list[tuple[Source, Element]], known: Described, links: _Names, joints: _Names
) -> Iterator[Misspelt]:
    slips = {"link": WordSlips(links.places), "joint": WordSlips(joints.places)}
    for source, element in elements:
        if not source.judged:
            continue
        if element.local in ("parent", "child") and element.parent is not None and element.parent.local == "joint":
            name, names, kind = element.get("link"), links, "link"
        elif element.local == "mimic":
            name, names, kind = element.get("joint"), joints, "joint"
        elif element.local == "gazebo":
            name, names, kind = element.get("reference"), links, "link"
        else:
            continue
        if name is None or name in links.places or name in joints.places:
            continue
        if "$" not in name and (known.has_link(name) or known.has(name)):
            continue
        near = slips[kind].meant(name)
        if near is not None:
            yield Misspelt(str(name), name.span, kind, near, names.places[near])


def _of_hardware(files: Files, elements: list[tuple[Source, Element]], hardware: _Names) -> Iterator[Misspelt]:
    """Names in sources of hardware that descriptions have otherwise, and the reverse."""
    code, asked = _Names(), set[str]()
    for path in [each for each in files.tree.paths if each.endswith(CPP)][:_MOST]:
        source = files.tree.at(path)
        if source is None or "hardware_interface" not in source.text:
            continue
        for match in _LITERAL.finditer(source.text):
            code.add(match[1], source.span(*match.span(1)))
            if _ASKED.search(source.text, max(0, match.start() - _BEFORE), match.start()):
                asked.add(match[1])
    meant = {*code.places, *_INTERFACES}
    slips = WordSlips({*meant, *(each for each, count in hardware.count.items() if count > 1)})
    for name, place in hardware.places.items():
        if place is not None and place.source.judged and hardware.count[name] == 1 and name not in meant:
            near = slips.meant(name)
            if near is not None:
                yield Misspelt(name, place, "hardware", near, code.places.get(near) or hardware.places.get(near))
    slips = WordSlips(hardware.places)
    for name, place in code.places.items():
        if place is not None and place.source.judged and code.count[name] == 1 and name not in hardware.places:
            near = slips.meant(name)
            if near is not None and (name in asked or near not in code.places):
                yield Misspelt(name, place, "code", near, hardware.places[near])


def _counted(tree: Tree, names: set[str]) -> Counter[str]:
    """How many places of the tree have the names."""
    word = {name: re.compile(rf"(?<![\w]){re.escape(name)}(?![\w])") for name in names}
    count: Counter[str] = Counter()
    for path in [path for path in tree.paths if path.endswith(_NAMING)][:_MOST]:
        source = tree.read(path, judged=False)
        if source is None:
            continue
        for name, pattern in word.items():
            if name in source.text:
                count[name] += len(pattern.findall(source.text))
    return count
