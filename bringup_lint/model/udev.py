"""What a udev rules file says: tokens, rules and the words of the grammar, as udev(7) names them."""

from __future__ import annotations

from functools import cached_property

from bringup_lint.dataclass import dataclass
from bringup_lint.dataclass import field
from bringup_lint.named_tuple import NamedTuple
from bringup_lint.source import Located
from bringup_lint.source import Problem
from bringup_lint.source import Source
from bringup_lint.source import Span
from bringup_lint.templates import has_placeholder

MATCH_OPERATORS = ("==", "!=")
PARENT_KEYS = ("KERNELS", "SUBSYSTEMS", "DRIVERS", "ATTRS", "TAGS")
"""The keys that search the device and its parents; all of one rule must hold on one and the same device."""


class Token(NamedTuple):
    """``KEY{attribute} operator "value"``."""

    key: Located
    attribute: Located | None
    """The text between the braces; None without braces."""
    operator: Located
    value: Located
    """Without its quotes and prefix, escapes resolved."""
    span: Span
    """From the key to the closing quote."""
    prefix: str = ""
    """``e`` (C escapes), ``i`` (matches any case), both or empty."""

    @property
    def is_match(self) -> bool:
        return self.operator in MATCH_OPERATORS

    @property
    def name(self) -> str:
        """``ATTRS{idVendor}``, ``KERNEL``."""
        return self.key if self.attribute is None else f"{self.key}{{{self.attribute}}}"

    @property
    def alternatives(self) -> tuple[str, ...]:
        """The glob patterns between the bars of a match value."""
        return tuple(self.value.split("|"))

    @property
    def has_substitution(self) -> bool:
        """Whether udev puts something into the value, or a template does."""
        return "$" in self.value or "%" in self.value or has_placeholder(self.value)


@dataclass(frozen=True, eq=False)
class Rule:
    """One logical line of a rules file."""

    tokens: tuple[Token, ...]
    span: Span
    dropped: bool = False
    """Whether udev ignores the line for an error in it; the tokens around the error are kept."""

    @cached_property
    def by_key(self) -> dict[str, list[Token]]:
        """Key -> its tokens, in the order of the line."""
        found: dict[str, list[Token]] = {}
        for token in self.tokens:
            found.setdefault(token.key, []).append(token)
        return found

    def matches(self, key: str) -> tuple[Token, ...]:
        tokens = self.by_key.get(key)
        return tuple([token for token in tokens if token.is_match]) if tokens else ()

    def assignments(self, key: str) -> tuple[Token, ...]:
        tokens = self.by_key.get(key)
        return tuple([token for token in tokens if not token.is_match]) if tokens else ()

    def first(self, key: str) -> Token | None:
        return next(iter(self.by_key.get(key, ())), None)

    @property
    def source(self) -> Source:
        return self.span.source


@dataclass(frozen=True, eq=False)
class RulesFile:
    """One ``*.rules`` file."""

    source: Source
    rules: tuple[Rule, ...] = ()
    problems: tuple[Problem, ...] = ()
    owners: dict[int, Rule] = field(default_factory=dict)
    """The rule to which each problem belongs, by the index of the problem."""
