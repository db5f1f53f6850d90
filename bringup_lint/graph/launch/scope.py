"""The launch context: configurations, environment, namespace and what is set for all following nodes."""

from __future__ import annotations

from dataclasses import dataclass
from dataclasses import field
from dataclasses import replace
from typing import NamedTuple

from bringup_lint.model.launch_values import Value
from bringup_lint.source import Span


class Binding(NamedTuple):
    """A launch configuration: its value with all defaults, and the same in terms of what the user may pass."""

    value: Value
    symbol: Value
    origin: Span
    declared: bool
    """Bound by a declaration's default, and so open to ``name:=value`` on the command line."""


@dataclass(slots=True)
class Scope:
    arguments: dict[str, Binding] = field(default_factory=dict)
    env: dict[str, Value] = field(default_factory=dict)
    namespaces: tuple[Value, ...] = ()
    """Pushed, outermost first."""
    remaps: tuple[tuple[Value, Value], ...] = ()
    parameters: tuple[Value, ...] = ()
    """Set for all following nodes, in order."""

    def copy(self) -> Scope:
        return replace(self, arguments=dict(self.arguments), env=dict(self.env))

    def cleared(self) -> Scope:
        """What a group sees that does not forward."""
        return Scope()
