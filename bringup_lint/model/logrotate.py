"""A logrotate file as it is written: global directives, and the stanzas that say what is rotated how."""

from __future__ import annotations

from bringup_lint.dataclass import dataclass
from bringup_lint.dataclass import field
from bringup_lint.named_tuple import NamedTuple
from bringup_lint.source import Located
from bringup_lint.source import Problem
from bringup_lint.source import Source
from bringup_lint.source import Span


class Directive(NamedTuple):
    name: Located
    value: Located
    """The rest of its line; empty when there is none."""
    span: Span


class Script(NamedTuple):
    name: Located
    """``postrotate`` and the like."""
    body: Located
    """The lines up to ``endscript``."""
    span: Span
    """From the name to the end of ``endscript``."""


@dataclass(slots=True)
class Stanza:
    """``PATH... { ... }``."""

    paths: list[Located]
    defaults: tuple[Directive, ...]
    """The global directives of the file above it."""
    header: Span
    directives: list[Directive] = field(default_factory=list)
    scripts: list[Script] = field(default_factory=list)
    skipped: bool = False
    """An error makes logrotate leave the whole stanza out."""
    closed: bool = False

    def own(self, *names: str) -> Directive | None:
        """The last directive of the stanza itself with one of the names."""
        return next((each for each in reversed(self.directives) if each.name in names), None)

    def get(self, *names: str) -> Directive | None:
        """The last directive with one of the names, of the stanza or the file's global ones."""
        return self.own(*names) or next((each for each in reversed(self.defaults) if each.name in names), None)


@dataclass(slots=True)
class LogrotateFile:
    source: Source
    directives: list[Directive] = field(default_factory=list)
    """The global ones."""
    stanzas: list[Stanza] = field(default_factory=list)
    problems: list[Problem] = field(default_factory=list)
    """What logrotate complains about. Those in ``parsers.logrotate.HARMLESS`` cost nothing but the line."""
    unread_from: int | None = None
    """Offset where logrotate stops reading; None when it reads all."""
