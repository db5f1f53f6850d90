"""A YAML tree whose every node knows where it is."""

from __future__ import annotations

from collections.abc import Iterator
from enum import Enum

from bringup_lint.dataclass import dataclass
from bringup_lint.dataclass import field
from bringup_lint.pattern import regex
from bringup_lint.source import Located
from bringup_lint.source import Problem
from bringup_lint.source import Source
from bringup_lint.source import Span


class YamlCode(str, Enum):
    """What a reader of YAML cannot read, or leaves out."""

    SYNTAX = "syntax"
    TAB = "tab"
    CONTROL_CHARACTER = "control-character"
    UNDEFINED_ALIAS = "undefined-alias"
    RECURSIVE_ALIAS = "recursive-alias"
    ALIAS_BOMB = "alias-bomb"
    """Aliases expand to too many nodes."""
    TOO_DEEP = "too-deep"


YAML11_BOOLEANS = {
    **dict.fromkeys(("yes", "Yes", "YES", "true", "True", "TRUE", "on", "On", "ON"), True),
    **dict.fromkeys(("no", "No", "NO", "false", "False", "FALSE", "off", "Off", "OFF"), False),
}
NULLS = frozenset(("", "~", "null", "Null", "NULL"))
INTEGER = regex(r"[-+]?(?:0|[1-9][0-9]*)\Z")


@dataclass(eq=False, slots=True)
class Scalar:
    """``value`` is the text as YAML reads it; its span leaves quotes out, ``span`` holds them."""

    value: Located
    span: Span
    style: str = ""
    """Empty for plain, else the sign that opens it: a quote, ``|`` or ``>``."""
    tag: str = ""
    """Only a tag that is written, such as ``!reset`` or ``tag:yaml.org,2002:str``."""
    size: int = 1

    @property
    def is_null(self) -> bool:
        return not self.style and not self.tag and self.value in NULLS

    @property
    def boolean(self) -> bool | None:
        """The truth value of a plain YAML 1.1 boolean, else None."""
        return None if self.style or self.tag else YAML11_BOOLEANS.get(self.value)

    @property
    def integer(self) -> int | None:
        """The number of a plain decimal integer, else None."""
        if self.style or self.tag or len(self.value) > 20 or not INTEGER.match(self.value):
            return None
        return int(self.value)


@dataclass(eq=False, slots=True)
class Sequence:
    span: Span
    items: list[Node] = field(default_factory=list)
    flow: bool = False
    tag: str = ""
    size: int = 1

    def __iter__(self) -> Iterator[Node]:
        return iter(self.items)

    @property
    def scalars(self) -> Iterator[Scalar]:
        return (item for item in self.items if isinstance(item, Scalar))


@dataclass(eq=False, slots=True)
class Mapping:
    """``pairs`` keeps the order of the text and every duplicate key."""

    span: Span
    pairs: list[tuple[Node, Node]] = field(default_factory=list)
    flow: bool = False
    tag: str = ""
    size: int = 1

    @property
    def entries(self) -> Iterator[tuple[Scalar, Node]]:
        """The pairs whose key is a scalar."""
        return ((key, value) for key, value in self.pairs if isinstance(key, Scalar))

    @property
    def merged(self) -> Iterator[tuple[Scalar, Node]]:
        """The pairs that count: the last of each name, then what merge keys (``<<``) add."""
        last = {str(key.value): (key, value) for key, value in self.entries if not _is_merge(key)}
        yield from last.values()
        for key, value in self.entries:
            if _is_merge(key):
                for base in value if isinstance(value, Sequence) else [value]:
                    if isinstance(base, Mapping):
                        fresh = {str(k.value): (k, v) for k, v in base.merged if str(k.value) not in last}
                        last.update(fresh)
                        yield from fresh.values()

    def entry(self, name: str) -> tuple[Scalar, Node] | None:
        """The last pair with this key; merge keys (``<<``) are followed when the mapping itself lacks it."""
        is_merged = False
        for key, value in reversed(self.pairs):
            if not isinstance(key, Scalar):
                continue
            if key.value == name:
                return key, value
            is_merged = is_merged or key.value == "<<"
        return self._merged_entry(name) if is_merged else None

    def _merged_entry(self, name: str) -> tuple[Scalar, Node] | None:
        merges = [value for key, value in self.pairs if isinstance(key, Scalar) and _is_merge(key)]
        bases = (base for merge in merges for base in (merge if isinstance(merge, Sequence) else [merge]))
        return next((e for b in bases if isinstance(b, Mapping) and (e := b.entry(name))), None)

    def get(self, name: str) -> Node | None:
        entry = self.entry(name)
        return entry[1] if entry else None

    def mapping(self, name: str) -> Mapping | None:
        value = self.get(name)
        return value if isinstance(value, Mapping) else None

    def sequence(self, name: str) -> Sequence | None:
        value = self.get(name)
        return value if isinstance(value, Sequence) else None

    def scalar(self, name: str) -> Scalar | None:
        value = self.get(name)
        return value if isinstance(value, Scalar) else None

    @property
    def duplicates(self) -> Iterator[tuple[Scalar, Scalar]]:
        """Keys that come again, each with the first of its name."""
        seen: dict[str, Scalar] = {}
        for key, _ in self.entries:
            first = seen.setdefault(key.value, key)
            if first is not key and not _is_merge(key):
                yield first, key


@dataclass(eq=False, slots=True)
class Alias:
    """``*name``, only where the reader was asked not to follow aliases."""

    span: Span
    size: int = 1


Node = Scalar | Sequence | Mapping | Alias


def _is_merge(key: Scalar) -> bool:
    return key.value == "<<" and not key.style


@dataclass(eq=False, slots=True)
class Document:
    root: Node | None = None
    complete: bool = True
    """False when an error broke it off: what is there was read, what is missing may be in the text."""


@dataclass(eq=False, slots=True)
class YamlFile:
    source: Source
    documents: list[Document] = field(default_factory=list)
    problems: list[Problem] = field(default_factory=list)
    repeated: list[Node] = field(default_factory=list)
    """What aliases repeat, once for each alias."""

    @property
    def root(self) -> Node | None:
        """The root of the first document."""
        return self.documents[0].root if self.documents else None

    @property
    def complete(self) -> bool:
        return not self.problems and all(document.complete for document in self.documents)

    @property
    def duplicates(self) -> Iterator[tuple[Scalar, Scalar]]:
        """Duplicate keys of every mapping, each with the first of its name."""
        for node in self.nodes:
            if isinstance(node, Mapping):
                yield from node.duplicates

    @property
    def nodes(self) -> Iterator[Node]:
        """Every node once, in the order of the text."""
        seen: set[int] = set()
        stack: list[Node] = [d.root for d in reversed(self.documents) if d.root is not None]
        while stack:
            node = stack.pop()
            if id(node) in seen:
                continue
            seen.add(id(node))
            yield node
            if isinstance(node, Sequence):
                stack.extend(reversed(node.items))
            elif isinstance(node, Mapping):
                stack.extend(part for pair in reversed(node.pairs) for part in reversed(pair))
