"""The strings of a JSON text with comments, each with the keys that lead to it. Linear, no recursion."""

from __future__ import annotations

from collections.abc import Iterator

from bringup_lint.pattern import regex
from bringup_lint.source import Located
from bringup_lint.source import Source

_TOKEN = regex(
    r"//[^\n]*|/\*[\s\S]*?(?:\*/|\Z)|\"(?P<text>(?:[^\"\\\n]|\\.)*)\"(?P<key>\s*:)?|(?P<open>[{\[])|(?P<close>[}\]])"
)


def strings(source: Source) -> Iterator[tuple[tuple[str, ...], Located]]:
    """Every string value with its path of keys; the items of a list have the path of the list."""
    path: list[str] = []
    depths: list[int] = []
    key: str | None = None
    for token in _TOKEN.finditer(source.text):
        if token["open"]:
            depths.append(len(path))
            if key is not None:
                path.append(key)
            key = None
        elif token["close"]:
            del path[depths.pop() if depths else 0 :]
            key = None
        elif token["key"]:
            key = token["text"]
        elif token["text"] is not None:
            yield (*path, *([key] if key is not None else [])), source.located(*token.span("text"))
            key = None
