"""fail2ban's jails."""

from __future__ import annotations

import re

from bringup_lint.dataclass import dataclass
from bringup_lint.dataclass import field
from bringup_lint.pattern import regex
from bringup_lint.source import Located
from bringup_lint.source import Source

_SECTION = regex(
    r"^\[(?P<section>[^\]\n]+)\]"
    r"|^(?P<key>[A-Za-z][\w.-]*)[ \t]*=[ \t]*(?P<value>[^\n#;]*?)[ \t\r]*(?:[#;].*)?$",
    re.M,
)


@dataclass(eq=False)
class Jail:
    """A fail2ban jail file: the last value of a key wins."""

    source: Source
    values: dict[tuple[str, str], Located] = field(default_factory=dict)

    def get(self, section: str, key: str) -> Located | None:
        return self.values.get((section, key))


def parse_jail(source: Source) -> Jail:
    """Read the sections and keys; indented continuation lines are left out."""
    jail, section = Jail(source), ""
    for match in _SECTION.finditer(source.text):
        if match["section"] is not None:
            section = match["section"].strip()
        elif section:
            jail.values[section, match["key"].lower()] = source.located(*match.span("value"))
    return jail
