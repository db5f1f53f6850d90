"""Text that every reader of JSON accepts."""

from __future__ import annotations

import re
from typing import Any

from bringup_lint.pattern import regex

_COMMAND = regex(r"##(?=(?:vso)?\[)", re.I)
_CONTROL = regex(r"[\x7f-\x9f\u061c\u200e\u200f\u2028-\u202e\u2066-\u2069]")


def harmless(written: str) -> str:
    """JSON that means the same, and in which a CI runner sees no command and a terminal no control character."""
    text = _COMMAND.sub(r"#\\u0023", written) if "##" in written else written
    return text if text.isascii() else _CONTROL.sub(lambda match: f"\\u{ord(match[0]):04x}", text)


def sound(data: Any) -> Any:
    """The same data with U+FFFD for what is no character: bytes of a file that are not UTF-8."""
    if isinstance(data, str):
        return data if data.isascii() else data.encode("utf-16", "surrogatepass").decode("utf-16", "replace")
    if isinstance(data, dict):
        return {sound(key): sound(value) for key, value in data.items()}
    return [sound(item) for item in data] if isinstance(data, list | tuple) else data
