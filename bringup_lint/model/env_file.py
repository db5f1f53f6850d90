"""An environment file as ``EnvironmentFile=`` reads it."""

from __future__ import annotations

from bringup_lint.dataclass import dataclass
from bringup_lint.dataclass import field
from bringup_lint.source import Located
from bringup_lint.source import Problem
from bringup_lint.source import Source
from bringup_lint.source import Span


@dataclass(frozen=True, slots=True)
class Entry:
    """One ``NAME=VALUE``; the value without its quotes and escapes, nothing expanded."""

    name: Located
    value: Located
    span: Span
    """The whole entry, without the last line end."""
    quoted: bool = False
    """Some of the value is in quotes."""


@dataclass(slots=True)
class EnvFile:
    """The entries in order; a later one of the same name wins."""

    source: Source
    entries: list[Entry] = field(default_factory=list)
    """Valid ones only: what systemd drops is in ``problems``."""
    problems: list[Problem] = field(default_factory=list)
