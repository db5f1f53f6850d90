"""The values that commands of CMake compute: of lists, paths and numbers (cmake-commands(7))."""

from __future__ import annotations

import os
from collections.abc import Iterable
from collections.abc import Sequence
from fnmatch import fnmatchcase

from bringup_lint.parsers.arithmetic import evaluate

MOST = 1000
"""Numbers of one loop."""


def element(items: Sequence[str], index: str) -> str | None:
    """``list(GET)`` with one index, from the end where it is negative; None when there is no such item."""
    try:
        return items[int(index)]
    except (ValueError, IndexError):
        return None


def number(expression: str) -> str | None:
    """``math(EXPR)``; None when it is more than sums, products and brackets of plain numbers."""
    value = evaluate(f"$(({expression}))", {})
    return None if value is None else str(value)


def part_of_path(path: str, part: str) -> str | None:
    """``get_filename_component``; None for parts that depend on the machine."""
    folder, name = os.path.split(path)
    if name in ("", ".", ".."):
        return None  # the name of the folder is that of the checkout
    stem = name.partition(".")[0]
    parts = {"NAME": name, "NAME_WE": stem, "EXT": name[len(stem) :], "DIRECTORY": folder, "PATH": folder}
    return parts.get(part)


def numbers(bounds: Sequence[str]) -> list[str] | None:
    """``foreach(RANGE stop)`` and ``foreach(RANGE start stop [step])``: the stop is the last one. None when the bounds
    are not plain numbers, or too far apart."""
    if not 1 <= len(bounds) <= 3 or not all(each.isdecimal() and len(each) < 10 for each in bounds):
        return None
    start, stop, step = [int(each) for each in (["0", *bounds, "1"] if len(bounds) == 1 else [*bounds, "1"])[:3]]
    if start > stop or step == 0 or (stop - start) // step >= MOST:
        return None
    return [str(each) for each in range(start, stop + 1, step)]


def matching(paths: Iterable[str], pattern: str, deep: bool) -> list[str]:
    """``file(GLOB)`` and, with ``deep``, ``file(GLOB_RECURSE)``: sorted, as CMake gives them. A star matches no slash;
    the name that ends a deep pattern is sought in all folders below."""
    *folders, name = os.path.normpath(pattern).split("/")
    found = []
    for path in paths:
        parts = path.split("/")
        fits = len(parts) > len(folders) if deep else len(parts) == len(folders) + 1
        if fits and fnmatchcase(parts[-1], name) and all(map(fnmatchcase, parts, folders)):
            found.append(path)
    return sorted(found)
