"""Options of daemons whose files hold one ``key=value`` a line: hostapd.conf(5)."""

from __future__ import annotations

import re

from bringup_lint.source import Located
from bringup_lint.source import Source


def option_of(source: Source, key: str) -> Located | None:
    """The last value of an option, without blanks around it."""
    found = list(re.finditer(rf"^[ \t]*{re.escape(key)}=[ \t]*(?P<value>[^\s#]+)", source.text, re.M))
    return source.located(*found[-1].span("value")) if found else None
