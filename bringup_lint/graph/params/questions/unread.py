"""Parameters that no source of the tree names, in the block of a node whose other parameters one source reads."""

from __future__ import annotations

import re
import sys
from collections import Counter
from collections.abc import Iterator
from typing import TYPE_CHECKING

from bringup_lint.facts.ros.parameters import hands_parameters
from bringup_lint.facts.ros.parameters import is_of_library
from bringup_lint.facts.ros.parameters import node_called
from bringup_lint.facts.ros.simulation import is_simulation
from bringup_lint.graph.launch.started import literal_text
from bringup_lint.named_tuple import NamedTuple
from bringup_lint.pattern import regex

if TYPE_CHECKING:
    from bringup_lint.graph.launch.launch import Launch
    from bringup_lint.graph.params.params import Params
    from bringup_lint.model.params import Block
    from bringup_lint.model.params import Parameter
    from bringup_lint.model.params import ParameterFile
    from bringup_lint.source import Source
    from bringup_lint.source import Span

_READ = regex(
    r"\b(?:get|declare)_parameter(?:_or|_if_not_declared)?\s{0,4}(?:<[^;(){}]{0,80}>\s{0,40})?"
    r"\(\s{0,80}(?:[\w.>-]{1,80},\s{0,80})?[\"'](?P<name>[\w./]{1,80})[\"']"
)
_LOOPED = regex(
    r"get_parameters_by_prefix|list_parameters|get_parameter_overrides|parameter_overrides\(\)"
    r"|\bParamListener\b|\bClassLoader\b|^[ \t]{0,20}#[ \t]{0,4}define\b[^\n]{0,200}param"
    r"|\b(?:get|declare)_parameter\s{0,4}(?:<[^;(){}]{0,80}>\s{0,40})?\(\s{0,80}[A-Za-z_*][^\"',;(){}]{0,80}(?:\(\))?\s{0,40}[,)]",
    re.I | re.M,
)
"""What reads parameters whatever they are called."""
_MADE = regex(
    r"[\"'+fF](?:(?<=\")(?P<before>[\w./]{2,80})\"\s{0,40}\+|(?<=\+)\s{0,40}\"(?P<after>[\w./]{2,80})\""
    r"|(?<=[fF])(?<!\w[fF])[\"'](?P<filled>[^\"'\n]{2,80})"
    r"|(?<=[\"'])(?P<edged>[._/][\w./]{1,80}|[\w./]{1,80}[._/])[\"']"
    r"|(?<=[\"'])(?P<holed>[\w./]{0,40}(?:\{\w{0,20}\}|%s)[\w./{}%]{0,40})[\"'])"
)
"""A text of which a source makes a name together with others. One set of letters first: it is searched for fast."""
_BASES = regex(
    r"\bclass\s+\w{1,80}\s{0,4}(?:\((?P<python>[^():]{1,200})\)|(?:final\s{0,4})?:(?P<cpp>(?:[^{};:]|::){1,400})\{)",
    hints="class",
)
_NODES = frozenset({"Node", "LifecycleNode"})
_INCLUDE = regex(r"^[ \t]*#[ \t]*include[ \t]*[<\"]([\w-]+)/", re.M)
_IMPORT = regex(r"^from[ \t]+(?P<package>\w{1,80})[\w.]{0,80}[ \t]+import[ \t]+(?P<names>[^\n#]{1,300})", re.M)
_WORD = regex(r"\w+")
_GIVEN = (
    r"::[^;}]{0,200}[(,{*]\s{0,40}"
    r"(?:this|shared_from_this|rclcpp::Node::SharedPtr\(this|(?:this->)?\w{0,40}node\w{0,40})\b"
)
"""What gives the node to a class of a library."""
_HOLE = regex(r"\{[^{}]{0,80}\}|%s")
_SHORT = 3
"""Letters of words that are in many names."""
SURE = 3
"""Parameters that a source must read, to be taken for that of the node."""
MOST = 0.6
"""The part of the block that these must be."""


class Unread(NamedTuple):
    """Parameters of one block that nothing reads."""

    file: ParameterFile
    block: Block
    parameters: tuple[Parameter, ...]
    reader: Span
    """Where a source begins to read the others."""
    read: int
    """How many these are."""
    names: frozenset[str]
    """All that it reads."""


def unread(params: Params, launch: Launch) -> Iterator[Unread]:
    """Only where the source is that of the node, by far the most of whose parameters it reads, and no launch file gives
    the name to a program of another origin."""
    files = [file for file in params.judged if file.accepted and not file.uncertain]
    blocks = [(file, block, own_parameters(block)) for file in files for block in file.blocks]
    asked = [(file, block, own) for file, block, own in blocks if len(own) > SURE]
    named = [(file, block, own, lacking) for file, block, own in asked if (lacking := _unnamed(params, own))]
    if not named:
        return
    reading = {source: names for source in params.code if len(names := _names(source)) >= SURE}
    by_name: dict[str, list[Source]] = {}
    for source, names in reading.items():
        for name in names:
            by_name.setdefault(name, []).append(source)
    foreign = _foreign(launch)
    pieces = _pieces(params)
    for file, block, own, lacking in named:
        readers, count = _readers(by_name, own)
        names = frozenset().union(*(reading[each] for each in readers))
        left = [each for each in lacking if not _is_made(str(each.name), names, pieces)]
        is_alone = not any(_is_helped(each, launch) for each in readers)
        is_own = any(_is_named(block.node_name, each) for each in readers)
        if left and is_alone and is_own and block.node_name not in foreign and count >= max(SURE, MOST * len(own)):
            first = next(_READ.finditer(readers[0].text))
            yield Unread(file, block, tuple(left), readers[0].span(*first.span("name")), count, names)


def _unnamed(params: Params, own: list[Parameter]) -> list[Parameter]:
    return [each for each in own if not params.is_named_in_code(str(each.name))]


def _readers(by_name: dict[str, list[Source]], own: list[Parameter]) -> tuple[list[Source], int]:
    """The sources that read the most of some parameters, and how many; none where one takes names from elsewhere."""
    counted = Counter(source for each in own for source in by_name.get(str(each.name), ()))
    count = max(counted.values(), default=0)
    readers = sorted((source for source, number in counted.items() if number == count), key=lambda each: each.name)
    if any(each.matches(_LOOPED) or is_simulation(each.basename) for each in readers):
        return [], 0
    return readers, count


def _is_named(label: str, source: Source) -> bool:
    """Whether a source has a word of the name of a node: many nodes read ``odom_frame`` and ``publish_rate``."""
    text = f"{source.name} {source.text}".lower()
    return any(each in text for each in label.lower().split("_") if len(each) > _SHORT)


def _is_helped(source: Source, launch: Launch) -> bool:
    """Whether a class or library that is not in the tree may declare parameters in the node of a source, too."""
    own = launch.workspace.packages
    libraries = {each for each in _INCLUDE.findall(source.text) if each not in own and hands_parameters(each)}
    for found in _IMPORT.finditer(source.text):
        package = found["package"]
        if package not in own and package not in sys.stdlib_module_names and hands_parameters(package):
            libraries.update(_WORD.findall(found["names"]))
    for found in _BASES.finditer(source.text):
        for base in (found["python"] or found["cpp"]).split(","):
            words = re.split(r"::|\.|\s", base.partition("<")[0].strip())
            if not libraries.isdisjoint(words) or (words[-1].endswith("Node") and words[-1] not in _NODES):
                return True
    return any(re.search(rf"\b{re.escape(each)}{_GIVEN}", source.text) for each in libraries)


def own_parameters(block: Block) -> list[Parameter]:
    """The parameters of a block for one node of the tree, besides those of the client library."""
    label = block.node_name
    if "*" in label or node_called(label) is not None:
        return []
    return [each for each in block.parameters if not is_of_library(str(each.name))]


def _names(source: Source) -> frozenset[str]:
    if source.basename.endswith(".launch.py") or "_parameter" not in source.text:
        return frozenset()
    return frozenset(found["name"] for found in _READ.finditer(source.text))


def _foreign(launch: Launch) -> set[str]:
    """The names of nodes that programs of other origins have."""
    own = launch.workspace.packages
    nodes = [node for node in launch.nodes if literal_text(node.package) not in own]
    return {str(literal_text(each)) for node in nodes for each in (node.name, node.executable)}


def _pieces(params: Params) -> set[str]:
    found: set[str] = set()
    for source in params.code:
        for match in _MADE.finditer(source.text):
            found.update(part for text in match.groups() if text for part in _HOLE.split(text) if len(part) > 1)
    return found


def _is_made(name: str, names: frozenset[str], pieces: set[str]) -> bool:
    """Whether a source reads a parameter, also under a name that it puts together."""
    if name in names:
        return True
    starts = [0, *(at + 1 for at, letter in enumerate(name) if letter == ".")]
    ends = range(1, len(name) + 1)
    return any(name[start:end] in pieces for start in starts for end in ends) or any(name[at:] in pieces for at in ends)
