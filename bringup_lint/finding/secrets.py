"""Secrets that a file gives away by their names, whether or not a rule has marked them."""

from __future__ import annotations

import re
from collections.abc import Iterator

from bringup_lint.source import Source
from bringup_lint.source import Span

_WORDS = ("pass", "psk", "secret", "token", "credential", "key", "://")
MERE_NAME = re.compile(r"pass(?:word|wd|phrase|wort)|secret|token", re.IGNORECASE)
"""A value that only repeats its name tells nothing, and masking it everywhere would mask prose."""
_NAME = r"""(?:pass(?:word|wd|phrase|wort)|psk|secret|token
    |(?:api|access|auth|private|secret|encryption|signing|shared)[_-]?key|wep[_-]?key\d?)"""
_VALUE = r"""(?:
    ["'\]]*[ \t]*[:=][ \t]*(?:"(?P<double>[^"\n]+)"|'(?P<single>[^'\n]+)')
    |["'\]]*[ \t]*:[ \t]+(?P<mapped>[^\s"'\#,}\]][^\n\#,}\]]*)
    |[ \t]*=[ \t]*(?P<assigned>[^\s"'=][^\s"']*)
    |["']?(?:>|[ \t]*</name>\s*<value>|[ \t]+(?:value|default)[ \t]*=[ \t]*["'])(?P<element>[^<"'\n]+))"""
_SECRETS = re.compile(
    rf"""{_NAME}{_VALUE}
    |--{_NAME}[ \t]+(?P<option>[^\s"'=-][^\s"']*)
    |://[^/\s:@"']*:(?P<url>[^@/\s"']+)@
    |SetCredential=[^:\s]+:(?P<credential>[^\n]+)
    |-----BEGIN[ ][A-Z ]*PRIVATE[ ]KEY-----(?P<block>[^-]+)""",
    re.IGNORECASE | re.VERBOSE,
)
_NO_SECRET = re.compile(
    r"\$[({a-z_]|\{\{|@\w+@|%[a-z%]$|/(?:etc|run|var|home|opt|usr|srv|tmp|root|mnt|dev|proc)\b|file:|!\w+$|<\w"
    r"|\S+\.(?:pem|key|crt|p12)$|(?:true|false|yes|no|on|off|null|none|\d|\*+)$",
    re.IGNORECASE,
)


def given_away(source: Source) -> Iterator[Span]:
    """The values of passwords, keys and tokens; not variables, paths and words that merely stand for one."""
    lowered = source.text.lower()
    if not any(word in lowered for word in _WORDS):
        return
    code = source.name.endswith(".py")
    for match in _SECRETS.finditer(source.text):
        name = match.lastgroup or ""
        bare = name in ("mapped", "assigned")
        if (code and bare) or _NO_SECRET.match(match[name].strip()):
            continue
        start = match.start(name)
        yield source.span(start, start + len(match[name].rstrip()))
