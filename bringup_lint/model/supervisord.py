"""Programs of supervisord: the ``[program:x]`` sections."""

from __future__ import annotations

from bringup_lint.dataclass import dataclass
from bringup_lint.dataclass import field
from bringup_lint.source import Located
from bringup_lint.source import Span


@dataclass(eq=False)
class Program:
    name: Located
    header: Span
    settings: dict[str, Located] = field(default_factory=dict)
    """Key -> value without its comment; the last one takes effect."""

    def get(self, key: str) -> Located | None:
        return self.settings.get(key)
