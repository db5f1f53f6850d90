"""A parameter file as rcl reads it: blocks of nodes, and the values that they set."""

from __future__ import annotations

from typing import Any
from typing import Union

from bringup_lint.dataclass import dataclass
from bringup_lint.dataclass import field
from bringup_lint.model.yaml_node import Node
from bringup_lint.named_tuple import NamedTuple
from bringup_lint.pattern import regex
from bringup_lint.source import Located
from bringup_lint.source import Problem
from bringup_lint.source import Source
from bringup_lint.source import Span

Plain = Union[bool, int, float, str]
Data = Union[Plain, list[Any], None]

TYPES = ("bool", "integer", "double", "string", "bool_array", "integer_array", "double_array", "string_array")
"""The types of rcl, in the order in which one wins when a parameter was given several."""
NOT_SET = "not_set"

OPENING = regex(
    r"(?:\ufeff?(?:[ \t]*(?:#[^\n]*|\r)?|---[^\n]*|%[^\n]*|(?!---)[ \t]*[\w/*\"'-]+[ \t]*:[ \t]*(?:#[^\n]*|\r)?)\n)*"
    r"[ \t]+[\"']?ros__parameters[\"']?[ \t]*:"
)
"""Nothing but bare keys above the first ``ros__parameters``, whatever is broken."""


class Value(NamedTuple):
    """What a parameter holds: a type of ``TYPES`` (or ``NOT_SET``) and the value."""

    type: str
    data: Data


@dataclass(eq=False, slots=True)
class Block:
    """One ``ros__parameters`` mapping. ``name`` is the node key as rcl joins it, such as ``x/n`` or ``/**``."""

    name: str
    key: Located
    """The last part of the node key, as written."""
    keys: tuple[Located, ...]
    """All parts of the node key, outermost first."""
    header: Located
    """The word ``ros__parameters``."""
    node: Node
    parameters: list[Parameter] = field(default_factory=list)

    @property
    def node_name(self) -> str:
        """Of the node that it is for, without the namespace."""
        return str(self.key).rpartition("/")[2]

    @property
    def span(self) -> Span:
        return self.key.span


@dataclass(eq=False, slots=True)
class Parameter:
    """One value that a block sets, in the order of the text."""

    name: str
    """With its prefixes: ``gains.p``."""
    key: Located
    value: Value
    node: Node
    """The value in the text."""
    block: Block

    @property
    def span(self) -> Span:
        """The value with its quotes or brackets."""
        return self.node.span

    @property
    def text(self) -> str:
        """The value as written, on one line."""
        return " ".join(self.node.span.text.split())


@dataclass(eq=False, slots=True)
class Entry:
    """A parameter of rcl's table: one value for each type that it was ever given."""

    name: str
    slots: dict[str, Data] = field(default_factory=dict)

    @property
    def value(self) -> Value | None:
        """The value that counts: that of the first type in ``TYPES``, not the last one written."""
        for type_ in TYPES:
            if type_ in self.slots:
                return Value(type_, self.slots[type_])
        return None


@dataclass(eq=False, slots=True)
class ParameterFile:
    source: Source
    blocks: list[Block] = field(default_factory=list)
    problems: list[Problem] = field(default_factory=list)
    """Each of them stops the process that loads the file."""
    nodes: dict[str, list[Entry]] = field(default_factory=dict)
    """rcl's table: node key -> parameters, both in the order in which they first appear."""
    uncertain: bool = False
    """Too deep or too large to be read to the end: nothing is known about what was left out."""

    @property
    def accepted(self) -> bool:
        return not self.problems

    @property
    def is_certain(self) -> bool:
        """Whether this is a parameter file at all, and not some other YAML that mentions the word."""
        if self.blocks or any(problem.code in ("no-node-name", "misspelt-header") for problem in self.problems):
            return True
        return bool(self.problems) and bool(OPENING.match(self.source.text))

    @property
    def parameters(self) -> list[Parameter]:
        return [parameter for block in self.blocks for parameter in block.parameters]

    def of_node(self, fqn: str) -> dict[str, Value]:
        """What a node with this fully qualified name gets: the last matching block wins, whatever it matches by."""
        found: dict[str, Value] = {}
        for name, entries in self.nodes.items():
            if matches(name, fqn):
                for entry in entries:
                    found[entry.name] = entry.value or Value(NOT_SET, None)
        return found


def matches(key: str, fqn: str) -> bool:
    """Whether a node key means a fully qualified name: ``*`` is one token, ``**`` any number of them, also none."""
    key, fqn = key.lstrip("/"), fqn.lstrip("/")
    if "*" not in key or key == "**":
        return key in (fqn, "**")
    tokens, names = key.split("/"), fqn.split("/")
    reachable = {0}
    for token in tokens:
        if token == "**" and reachable:
            reachable = set(range(min(reachable), len(names) + 1))
        else:
            reachable = {at + 1 for at in reachable if at < len(names) and token in ("*", names[at])}
    return len(names) in reachable
