"""sshd_config as it is written, and what sshd makes of it."""

from __future__ import annotations

from bringup_lint.dataclass import dataclass
from bringup_lint.dataclass import field
from bringup_lint.named_tuple import NamedTuple
from bringup_lint.source import Located
from bringup_lint.source import Problem
from bringup_lint.source import Source
from bringup_lint.source import Span


class Match(NamedTuple):
    """The ``Match`` line that a line belongs to."""

    keyword: Located
    condition: str
    always: bool
    """``Match all``."""


class Option(NamedTuple):
    keyword: Located
    name: str
    """The keyword in its usual spelling, aliases resolved; as written when it is unknown."""
    arguments: tuple[Located, ...]
    match: Match | None
    span: Span

    @property
    def value(self) -> Located:
        """The first argument; empty when there is none."""
        return self.arguments[0] if self.arguments else self.keyword.part(len(self.keyword), len(self.keyword))

    @property
    def everywhere(self) -> bool:
        """Whether the line counts for every connection."""
        return self.match is None or self.match.always


@dataclass(slots=True)
class SshdFile:
    source: Source
    options: list[Option] = field(default_factory=list)
    problems: list[Problem] = field(default_factory=list)
    """In the order of the lines: what makes sshd refuse to start, and ``deprecated``."""
