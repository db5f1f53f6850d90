"""An XML document as a located tree; namespaces are kept as written and resolved on demand."""

from __future__ import annotations

from collections.abc import Iterator

from bringup_lint.dataclass import dataclass
from bringup_lint.dataclass import field
from bringup_lint.source import Located
from bringup_lint.source import Problem
from bringup_lint.source import Source
from bringup_lint.source import Span


@dataclass(slots=True)
class Attribute:
    name: Located
    """As written, with its prefix."""
    value: Located
    """Without quotes, character references decoded."""


@dataclass(slots=True, eq=False)
class Element:
    name: Located
    """As written in the start tag, with its prefix."""
    attributes: tuple[Attribute, ...]
    parent: Element | None
    tag: Span
    """The start tag, from ``<`` to ``>``."""
    span: Span
    """From the start tag to the end tag."""
    children: list[Element] = field(default_factory=list)
    texts: list[Located] = field(default_factory=list)
    """The runs of text directly inside, between tags and comments; CDATA is decoded."""

    @property
    def local(self) -> Located:
        """The name without its prefix."""
        return local_part(self.name)

    @property
    def text(self) -> Located:
        """All direct text, trimmed; with its place where it starts."""
        runs = [run for run in self.texts if run.strip()]
        if not runs:
            end = self.tag.end
            return Located("", Span(self.tag.source, end, end))
        joined = runs[0] if len(runs) == 1 else _join(runs)
        return joined.strip_located()

    def get(self, name: str) -> Located | None:
        """The value of an attribute by its exact name."""
        return next((each.value for each in self.attributes if each.name == name), None)

    def find(self, name: str) -> Element | None:
        """The first child with this local name."""
        return next(self.find_all(name), None)

    def find_all(self, name: str) -> Iterator[Element]:
        """The children with this local name."""
        return (child for child in self.children if child.local == name)

    def walk(self) -> Iterator[Element]:
        """This element and all below it, in document order."""
        pending = [self]
        while pending:
            element = pending.pop()
            yield element
            pending.extend(reversed(element.children))

    @property
    def ancestors(self) -> Iterator[Element]:
        """The elements around this one, the nearest first."""
        outer = self.parent
        while outer is not None:
            yield outer
            outer = outer.parent

    @property
    def namespace(self) -> str:
        """The URI that the prefix (or the default namespace) stands for; empty when there is none."""
        prefix = self.name.rpartition(":")[0]
        wanted = f"xmlns:{prefix}" if prefix else "xmlns"
        values = (element.get(wanted) for element in (self, *self.ancestors))
        return str(next((value for value in values if value is not None), ""))


@dataclass(slots=True, eq=False)
class Document:
    source: Source
    root: Element | None = None
    others: list[Element] = field(default_factory=list)
    """Elements after the root and outside it, for libraries that choose theirs by its name."""
    declaration: Span | None = None
    doctype: Span | None = None
    instructions: list[Span] = field(default_factory=list)
    """Processing instructions, the XML declaration left out."""
    problems: list[Problem] = field(default_factory=list)

    @property
    def elements(self) -> Iterator[Element]:
        """All elements, in document order."""
        return iter(()) if self.root is None else self.root.walk()

    def let_go(self) -> None:
        """Take the elements apart when nobody asks for them any more: as long as children know their parents, they wait
        for a search for garbage."""
        for element in self.elements:
            element.parent = None


def local_part(name: Located) -> Located:
    """A name without its namespace prefix."""
    return name.part(name.rfind(":") + 1, len(name))


def _join(runs: list[Located]) -> Located:
    pieces: list[tuple[int, int]] = []
    offset = 0
    for run in runs:
        pieces.extend((offset + inner, outer) for inner, outer in run.pieces or ((0, run.span.start),))
        offset += len(run)
    span = Span(runs[0].span.source, runs[0].span.start, runs[-1].span.end)
    return Located("".join(runs), span, tuple(pieces))
