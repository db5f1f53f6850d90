"""The arguments of a call, by position or name."""

from __future__ import annotations

from typing import Any

from bringup_lint.model.launch_values import Literal
from bringup_lint.model.launch_values import Unknown
from bringup_lint.named_tuple import NamedTuple
from bringup_lint.source import Span


class Arguments(NamedTuple):
    positional: list[Any]
    keywords: dict[str, Any]
    more: bool
    """Further arguments may be passed than are known."""
    span: Span

    def get(self, name: str, index: int | None = None) -> Any:
        """The argument, or None when it is not given."""
        if name in self.keywords:
            return self.keywords[name]
        if index is not None and index < len(self.positional):
            return self.positional[index]
        return None

    def need(self, name: str, index: int | None = None) -> Any:
        """The argument; Unknown when it is not given."""
        value = self.get(name, index)
        return Unknown(f"no {name}", self.span) if value is None else value

    def word(self, name: str, index: int | None = None) -> str | None:
        """A literal string argument."""
        value = self.get(name, index)
        return value.value if isinstance(value, Literal) and isinstance(value.value, str) else None
