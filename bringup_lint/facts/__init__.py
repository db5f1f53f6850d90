"""Tables of facts: data files by subject, each with its source in its header, read when first asked for."""

from __future__ import annotations

import os
from functools import cache

_FOLDER = os.path.dirname(__file__)


@cache
def rows(name: str) -> tuple[tuple[str, ...], list[tuple[str, ...]]]:
    """Column names and rows of ``NAME.tsv``, such as ``systemd/units``: tab-separated, no quoting, comments only at the
    top."""
    with open(os.path.join(_FOLDER, f"{name}.tsv"), encoding="utf-8") as file:
        lines = file.read().split("\n")
    at = 0
    while lines[at].startswith("#"):
        at += 1
    columns = tuple(lines[at].split("\t"))
    return columns, [tuple(line.split("\t")) for line in lines[at + 1 :] if line]


@cache
def table(name: str) -> list[dict[str, str]]:
    """The rows of ``NAME.tsv`` as dictionaries. They are shared: do not change them."""
    columns, found = rows(name)
    return [dict(zip(columns, row, strict=True)) for row in found]
