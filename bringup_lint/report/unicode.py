"""Text that every reader of JSON accepts."""

from __future__ import annotations

from typing import Any


def sound(data: Any) -> Any:
    """The same data with U+FFFD for what is no character: bytes of a file that are not UTF-8."""
    if isinstance(data, str):
        return data if data.isascii() else data.encode("utf-16", "surrogatepass").decode("utf-16", "replace")
    if isinstance(data, dict):
        return {sound(key): sound(value) for key, value in data.items()}
    return [sound(item) for item in data] if isinstance(data, list | tuple) else data
