"""What is gathered for a summary, without secrets: values that are one are left out, key material becomes marks."""

from __future__ import annotations

import hmac
from collections.abc import Iterator
from collections.abc import Mapping
from functools import cached_property
from hashlib import sha256
from typing import TYPE_CHECKING

from bringup_lint.dataclass import dataclass
from bringup_lint.dataclass import field
from bringup_lint.finding.redact import mask_of
from bringup_lint.fleet.summary import Fact
from bringup_lint.fleet.summary import Mark
from bringup_lint.source import Located
from bringup_lint.source import Source
from bringup_lint.source import Span

if TYPE_CHECKING:
    from bringup_lint.finding.redact import Mask
    from bringup_lint.robot import Robot

MOST = 20_000
"""Statements of one robot; no real one comes near."""
LONGEST = 400
"""Characters of a value."""


@dataclass
class Statements:
    """What the parts of ``fleet.reduce`` add the facts and marks of one robot to."""

    robot: Robot
    key: bytes
    """Made for this run; without it nobody can try out guesses on the digests."""
    delivered: Mapping[str, str] | None = None
    """Path on the robot -> the file that Ansible copies there, where only such are read. They may be templates: what a
    variable or a condition decides is another one on each robot."""
    facts: dict[Fact, None] = field(default_factory=dict)
    marks: dict[Mark, None] = field(default_factory=dict)
    _masks: dict[Source, Mask | None] = field(default_factory=dict)

    def state(self, subject: str, key: str, value: object, where: Located | Span) -> None:
        """Add a fact, unless its value is a secret."""
        span = where.span if isinstance(where, Located) else where
        if self.delivered is not None and _is_filled_in(span):
            return
        text = " ".join(str(value).split())
        if not span.source.judged or len(self.facts) >= MOST or self._is_secret(text, span):
            return
        self.facts[Fact(subject, key, text[:LONGEST], span.path, span.line)] = None

    def mark(self, kind: str, name: str, material: str | bytes, where: Located | Span) -> None:
        """Add a keyed hash of key material."""
        data = material.encode("utf-8", "surrogatepass") if isinstance(material, str) else material
        span = where.span if isinstance(where, Located) else where
        if self.delivered is not None and _is_filled_in(span):
            return
        if data.strip() and len(self.marks) < MOST:
            digest = hmac.new(self.key, kind.encode() + b"\0" + data, sha256).hexdigest()[:32]
            self.marks[Mark(kind, name, digest, span.path, span.line)] = None

    def _is_secret(self, text: str, span: Span) -> bool:
        source = span.source
        if source not in self._masks:
            self._masks[source] = mask_of((), [source])
        mask = self._masks[source]
        if mask is None:
            return False
        inside = any(each.start < span.end and span.start < each.end for each in mask.spans.get(source, ()))
        return inside or mask.words(text) != text

    @cached_property
    def places(self) -> dict[str, list[str]]:
        """Path on the robot -> the files of the tree that lie there."""
        if self.delivered is not None:
            return {place: [path] for place, path in self.delivered.items()}
        found: dict[str, list[str]] = {}
        for path in self.robot.tree.paths:
            place = self.robot.tree.robot_path(path)
            if place is not None:
                found.setdefault(place, []).append(path)
        return found

    def file(self, place: str) -> Source | None:
        """The file at a path of the robot, when there is exactly one."""
        paths = self.places.get(place, [])
        return self._read(paths[0]) if len(paths) == 1 else None

    def files(self, *endings: str, below: str = "/") -> Iterator[tuple[str, Source]]:
        """The files with such a name, each with its path on the robot."""
        for place, paths in sorted(self.places.items()):
            if len(paths) == 1 and place.startswith(below) and place.endswith(endings):
                source = self._read(paths[0])
                if source is not None and source.text:
                    yield place, source

    def _read(self, path: str) -> Source | None:
        tree = self.robot.tree
        return None if tree.is_link(path) or not tree.judges(path) else tree.read(path, judged=True)


def _is_filled_in(span: Span) -> bool:
    return "{{" in span.source.line_text(span.line) or "{%" in span.source.text
