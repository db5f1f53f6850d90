"""TOML, with the standard library's reader where there is one."""

from __future__ import annotations

import sys
from typing import Any


def read_toml(text: str) -> dict[str, Any]:
    """Raises ValueError with line and column."""
    if sys.version_info >= (3, 11):
        import tomllib
    else:
        import tomli as tomllib
    parsed: dict[str, Any] = tomllib.loads(text)
    return parsed


def quoted(text: str) -> str:
    """The basic string that stands for a text. Raises ValueError for a name of a file whose bytes are not UTF-8, which
    TOML cannot hold."""
    import json

    text.encode("utf-8")
    return json.dumps(text, ensure_ascii=False).replace("\x7f", "\\u007f")
