"""TOML, with the standard library's reader where there is one."""

from __future__ import annotations

import sys

from bringup_lint.pattern import regex
from bringup_lint.type_names import Any

_LONGEST = 50
_PART = r"""(?:(?<![\w-])[\w-]+|"[^"\n]*"|'[^'\n]*')[ \t]*\.[ \t]*"""
_AT_LINE = regex(r"\bat line (\d+)")
_LONG_KEY = regex(rf"(?:{_PART}){{{_LONGEST}}}")


def read_toml(text: str) -> dict[str, Any]:
    """Raises ValueError, mostly with line and column. The time that the reader takes grows with the square of the
    parts of a dotted key."""
    if _LONG_KEY.search(text):
        raise ValueError(f"a key of more than {_LONGEST} parts")
    if sys.version_info >= (3, 11):
        import tomllib
    else:
        import tomli as tomllib
    parsed: dict[str, Any] = tomllib.loads(text)
    return parsed


def line_of(error: Exception, text: str) -> int | None:
    """The line that the reader's error names, from 1."""
    if found := _AT_LINE.search(str(error)):
        return int(found.group(1))
    return text.rstrip().count("\n") + 1 if "at end of document" in str(error) else None


def holds(text: str) -> bool:
    """Whether TOML can hold a text: the name of a file may be bytes that are not UTF-8."""
    try:
        text.encode("utf-8")
    except UnicodeEncodeError:
        return False
    return True


def quoted(text: str) -> str:
    """The basic string that stands for a text that TOML can hold."""
    import json

    return json.dumps(text, ensure_ascii=False).replace("\x7f", "\\u007f")
