"""The one reader of YAML: libyaml's events become located nodes; nothing is constructed or raised."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Protocol

import yaml

from bringup_lint.model.yaml_node import Alias
from bringup_lint.model.yaml_node import Document
from bringup_lint.model.yaml_node import Mapping
from bringup_lint.model.yaml_node import Node
from bringup_lint.model.yaml_node import Scalar
from bringup_lint.model.yaml_node import Sequence
from bringup_lint.model.yaml_node import YamlCode
from bringup_lint.model.yaml_node import YamlFile
from bringup_lint.parsers.yaml_text import content
from bringup_lint.pattern import regex
from bringup_lint.source import Located
from bringup_lint.source import Problem
from bringup_lint.source import Source
from bringup_lint.source import Span

DEEPEST = 100
"""Levels of nesting that are kept; what lies deeper is left out with a problem."""
HOPELESS = 10 * DEEPEST
"""Levels of nesting at which reading ends: the time that libyaml takes for a token grows with them."""
LARGEST = 100_000
"""Nodes that aliases may add, counted as if each were copied; then an alias stays empty."""
FORBIDDEN = regex("[^\t\n\r\x20-\x7e\x85\xa0-\ud7ff\ue000-\ufffd\U00010000-\U0010ffff]")

LOADER = getattr(yaml, "CLoader", yaml.Loader)


def parse(source: Source, *, follow_aliases: bool = True) -> YamlFile:
    """Read all documents. The codes of the problems are those of ``YamlCode``; the detail is in the words of libyaml.

    Aliases stand for their targets, or stay ``Alias`` nodes when they are not followed.
    """
    return _Builder(source, follow_aliases).build()


class _Mark(Protocol):
    """libyaml's marks and those of PyYAML's own loader."""

    @property
    def index(self) -> int: ...


class _Hopeless(Exception):
    """Nested so deep that nothing more is read."""


class _Builder:
    def __init__(self, source: Source, follow_aliases: bool) -> None:
        self.file = YamlFile(source)
        self.follow_aliases = follow_aliases
        text = source.text
        self.shift = 1 if text.startswith("\ufeff") else 0
        for match in FORBIDDEN.finditer(text):
            self.problem(YamlCode.CONTROL_CHARACTER, match.start(), match.end(), f"U+{ord(match[0]):04X}")
            break
        self.text = FORBIDDEN.sub("\ufffd", text[self.shift :])
        self.open: list[Sequence | Mapping] = []
        self.keys: list[Node | None] = []
        """For every open mapping the key that waits for its value."""
        self.anchors: dict[str | None, Node] = {}
        self.skipping = 0
        self.expanded = 0

    def build(self) -> YamlFile:
        try:
            for event in self.events():
                self.take(event)
        except yaml.YAMLError as error:
            self.broken(error)
        except _Hopeless:
            pass  # said as too-deep
        return self.file

    def events(self) -> Iterator[yaml.Event]:
        loader = LOADER(self.text)
        try:
            while loader.check_event():
                yield loader.get_event()
        finally:
            loader.dispose()

    def take(self, event: yaml.Event) -> None:
        if isinstance(event, yaml.ScalarEvent):
            if not self.skipping:
                self.add(self.scalar(event), event.anchor)
        elif isinstance(event, yaml.AliasEvent):
            if not self.skipping:
                self.add(self.alias(event))
        elif isinstance(event, yaml.CollectionStartEvent):
            self.start(event)
        elif isinstance(event, yaml.CollectionEndEvent):
            self.end(event)
        elif isinstance(event, yaml.DocumentStartEvent):
            self.file.documents.append(Document())
            self.anchors.clear()

    def start(self, event: yaml.CollectionStartEvent) -> None:
        if self.skipping or len(self.open) >= DEEPEST:
            if not self.skipping:
                self.problem(YamlCode.TOO_DEEP, *self.range(event), f"nested deeper than {DEEPEST} levels")
                self.add(self.nothing(event))
            self.skipping += 1
            if self.skipping > HOPELESS:
                raise _Hopeless
            return
        kind = Sequence if isinstance(event, yaml.SequenceStartEvent) else Mapping
        node = kind(self.span(*self.range(event)), flow=bool(event.flow_style), tag=event.tag or "")
        self.add(node, event.anchor)
        self.open.append(node)
        self.keys.append(None)

    def end(self, event: yaml.CollectionEndEvent) -> None:
        if self.skipping:
            self.skipping -= 1
            return
        node = self.open.pop()
        if isinstance(node, Mapping):
            node.size += sum(key.size + value.size for key, value in node.pairs)
        else:
            node.size += sum(item.size for item in node.items)
        self.keys.pop()
        start, end = node.span.start, self.range(event)[1]
        if not node.flow:
            last = _last(node)
            end = last.end if last and last.end > start else node.span.end
        node.span = self.span(start, max(start, end))

    def add(self, node: Node, anchor: str | None = None) -> None:
        if anchor:
            self.anchors[anchor] = node
        if not self.open:
            self.file.documents[-1].root = node
            return
        parent = self.open[-1]
        if isinstance(parent, Sequence):
            parent.items.append(node)
        elif self.keys[-1] is None:
            self.keys[-1] = node
        else:
            parent.pairs.append((self.keys[-1], node))
            self.keys[-1] = None

    def scalar(self, event: yaml.ScalarEvent) -> Scalar:
        start, end = self.range(event)
        style = event.style or ""
        named = bool(event.anchor or event.tag)
        value, span = content(self.file.source, start, end, event.value, style, named)
        return Scalar(value, span, style, event.tag or "")

    def alias(self, event: yaml.AliasEvent) -> Node:
        target = self.anchors.get(event.anchor)
        if target is not None:
            self.file.repeated.append(target)
        if not self.follow_aliases:
            return Alias(self.span(*self.range(event)))
        if target is None:
            self.problem(YamlCode.UNDEFINED_ALIAS, *self.range(event), f"*{event.anchor} has no anchor before it")
        elif any(target is node for node in self.open):
            self.problem(YamlCode.RECURSIVE_ALIAS, *self.range(event), f"*{event.anchor} contains itself")
        elif self.expanded + target.size > LARGEST:
            self.problem(YamlCode.ALIAS_BOMB, *self.range(event), f"aliases expand to more than {LARGEST} nodes")
        else:
            self.expanded += target.size
            return target
        return self.nothing(event)

    def nothing(self, event: yaml.Event) -> Scalar:
        start, _ = self.range(event)
        span = self.span(start, start)
        return Scalar(Located("", span), span)

    def broken(self, error: yaml.YAMLError) -> None:
        """Keep what was read before the error; close what is open."""
        if self.file.documents:
            self.file.documents[-1].complete = False
        for node in self.open:
            last = _last(node)
            if last and last.end > node.span.end:
                node.span = self.span(node.span.start, last.end)
        mark = getattr(error, "problem_mark", None)
        at = min((mark.index if mark else 0) + self.shift, len(self.file.source.text))
        detail = getattr(error, "problem", None) or getattr(error, "reason", None) or "not valid YAML"
        code = YamlCode.TAB if self.file.source.text[at : at + 1] == "\t" else YamlCode.SYNTAX
        self.problem(code, at, min(at + 1, len(self.file.source.text)), str(detail))

    def problem(self, code: YamlCode, start: int, end: int, detail: str) -> None:
        if len(self.file.problems) < 100:
            self.file.problems.append(Problem(code, self.span(start, end), detail))

    def range(self, event: yaml.Event) -> tuple[int, int]:
        start = _index(event.start_mark) + self.shift
        return start, max(start, _index(event.end_mark) + self.shift)

    def span(self, start: int, end: int) -> Span:
        return Span(self.file.source, start, end)


def _index(mark: _Mark | None) -> int:
    """Every event of a loader has marks; only those that are made by hand have none."""
    return 0 if mark is None else mark.index


def _last(node: Sequence | Mapping) -> Span | None:
    """The child that ends a block collection; an alias' target is elsewhere and doesn't count."""
    if isinstance(node, Sequence):
        children = node.items[-1:]
    else:
        children = [part for part in node.pairs[-1]] if node.pairs else []
    return max((c.span for c in children), key=lambda span: span.end, default=None)
