"""What follows from the values of one parameter file: items of lists, duplicates, overridden blocks, tabs."""

from __future__ import annotations

import re
from collections.abc import Iterable
from collections.abc import Iterator

from bringup_lint.facts.ros.nav2_plugins import DEFAULTS
from bringup_lint.model.params import NOT_SET
from bringup_lint.model.params import Block
from bringup_lint.model.params import Data
from bringup_lint.model.params import Parameter
from bringup_lint.model.params import ParameterFile
from bringup_lint.model.params import Value
from bringup_lint.model.params import matches
from bringup_lint.model.yaml_node import Mapping
from bringup_lint.model.yaml_node import Scalar
from bringup_lint.model.yaml_node import Sequence
from bringup_lint.named_tuple import NamedTuple
from bringup_lint.parsers.param_scalar import scalar
from bringup_lint.parsers.params import parse
from bringup_lint.pattern import regex
from bringup_lint.source import Source
from bringup_lint.source import Span

TAB = regex(r"^[ \t]*\t[ \t]*", re.M)
_SWITCH = regex(r"(?:\w+_)?enabled?\Z")
"""A parameter that says whether a section is in use."""
_LISTS = regex(r"(?:^|_)(?:plugins|filters)\Z")
"""What the servers of Navigation2 call the lists of the sections that they read."""
WIDTHS = (2, 4, 8)
WILDCARDS = 16
"""The last blocks with a wildcard that are compared with those for one node; a file has one or two."""


class Item(NamedTuple):
    """A scalar of a parameter: the value itself, or an element of its list."""

    type: str
    data: Data
    text: str
    span: Span
    quoted: bool


def items(parameter: Parameter) -> list[Item]:
    """The scalars of a value; empty when a list holds anything else."""
    node = parameter.node
    if isinstance(node, Scalar) and parameter.value.type != NOT_SET:
        return [_item(node, parameter.value)]
    nodes = node.items if isinstance(node, Sequence) else [node]
    scalars = [each for each in nodes if isinstance(each, Scalar)]
    if len(scalars) < len(nodes):
        return []
    return [_item(each, scalar(each.value, each.style, each.tag)) for each in scalars]


def _item(node: Scalar, value: Value) -> Item:
    return Item(value.type, value.data, str(node.value), node.span, bool(node.style or node.tag))


def switched_off(block: Block) -> frozenset[str]:
    """The sections of a block that say that they are not in use, as with ``enabled: false``, and those of plugins that
    no list of plugins of the block has, nor the default of a list that it does not give."""
    parts = [(each, *each.name.rpartition(".")) for each in block.parameters]
    off = {section for each, section, _, name in parts if section and each.value.data is False and _SWITCH.match(name)}
    top = {name: each for each, section, _, name in parts if not section}
    plugins = {section for _, section, _, name in parts if name == "plugin" and "." not in section}
    return frozenset(off | (plugins - _in_use(top.values()) if plugins and any(map(_LISTS.search, top)) else set()))


def _in_use(parameters: Iterable[Parameter]) -> set[str]:
    """The names that the lists of a block have, or the server takes for those that are missing or empty."""
    given = {each.name: {item.text for item in items(each)} for each in parameters}
    return set().union(*given.values(), *(names for each, names in DEFAULTS.items() if not given.get(each)))


def holds_maps(parameter: Parameter) -> bool:
    """Whether rcl mixes up the values of several mappings in a list; one mapping alone keeps its names and values."""
    node = parameter.node
    return isinstance(node, Sequence) and sum(isinstance(each, Mapping) for each in node.items) > 1


def is_flattened(parameter: Parameter) -> bool:
    """Whether rcl takes the one inner list of a list for the whole, without a word."""
    node = parameter.node
    return isinstance(node, Sequence) and len(node.items) == 1 and isinstance(node.items[0], Sequence)


def duplicates(file: ParameterFile) -> Iterator[tuple[Parameter, Parameter]]:
    """Parameters that come again in the same block, each with the one before."""
    for block in file.blocks:
        seen: dict[str, Parameter] = {}
        for parameter in block.parameters:
            if parameter.name in seen:
                yield seen[parameter.name], parameter
            seen[parameter.name] = parameter


def winners(file: ParameterFile) -> dict[tuple[str, str], Value | None]:
    """Node key and parameter -> what rcl's table holds for it in the end."""
    return {(name, entry.name): entry.value for name, entries in file.nodes.items() for entry in entries}


def taken_back(file: ParameterFile) -> Iterator[tuple[Parameter, Parameter]]:
    """Values of a block for one node that a later block with a wildcard replaces by others, each with the last one."""
    lasting: dict[str, dict[str, Parameter]] = {}
    for block in file.blocks:
        for parameter in block.parameters:
            lasting.setdefault(block.name, {})[parameter.name] = parameter
    later: list[str] = []
    for key in reversed([key for key in file.nodes if key in lasting]):
        if "*" in key:
            later = [*later, key][:WILDCARDS]
        else:
            yield from _replaced(lasting[key], [lasting[general] for general in later if matches(general, key)])


def _replaced(
    specific: dict[str, Parameter], later: list[dict[str, Parameter]]
) -> Iterator[tuple[Parameter, Parameter]]:
    """The values that differ from those of the first of the later blocks that holds them."""
    for name, lost in specific.items():
        wins = next((block[name] for block in later if name in block), None)
        if wins is not None and wins.value != lost.value:
            yield lost, wins


def indenting_tabs(file: ParameterFile) -> Iterator[Span]:
    """Every tab in the blanks before a line."""
    for match in TAB.finditer(file.source.text):
        for at in range(match.start(), match.end()):
            if file.source.text[at] == "\t":
                yield Span(file.source, at, at + 1)


def _with_blanks(text: str, width: int) -> str:
    """Tabs in the indentation replaced by as many blanks each."""
    return TAB.sub(lambda match: match[0].replace("\t", " " * width), text)


def tab_width(file: ParameterFile) -> int | None:
    """How many spaces a tab stands for, when the file can be read then and means the same with every usual width."""
    if len(file.source.text) > 200_000:
        return None
    tables = []
    for width in WIDTHS:
        text = _with_blanks(file.source.text, width)
        read = parse(Source(file.source.name, text))
        if read.accepted:
            tables.append(
                (width, [(name, [(e.name, e.value) for e in entries]) for name, entries in read.nodes.items()])
            )
    same = len(tables) == len(WIDTHS) and all(table == tables[0][1] for _, table in tables)
    return tables[0][0] if same else None
