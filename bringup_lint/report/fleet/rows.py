"""JSON in pieces, as ``json.dumps`` writes it with an indent of two."""

from __future__ import annotations

import json
from collections.abc import Iterable
from collections.abc import Iterator

from bringup_lint.report.unicode import harmless
from bringup_lint.report.unicode import sound


def written(data: object) -> str:
    return harmless(json.dumps(sound(data), indent=2))


def indented(text: str, indent: str) -> str:
    return indent + text.replace("\n", f"\n{indent}")


def rows(before: str, items: Iterable[object], indent: str) -> Iterator[str]:
    """A list, row after row; ``indent`` is that of its line."""
    sign = f"{before}["
    for item in items:
        yield f"{sign}\n{indented(written(item), f'{indent}  ')}"
        sign = ","
    yield f"\n{indent}]" if sign == "," else f"{sign}]"
