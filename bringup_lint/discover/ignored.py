"""Which files git leaves out: those are made on the machine and can't be judged as missing."""

from __future__ import annotations

import os
from collections.abc import Iterator
from pathlib import Path

_LARGEST = 200_000
"""Bytes of a .gitignore that are read."""


def is_ignored(path: str) -> bool:
    """Whether a .gitignore between the file and the top of its repository names the file or a folder above it."""
    return any(_matches(folder, path) for folder in _folders(path))


def _folders(path: str) -> Iterator[str]:
    """The folders above a path, up to the top of the repository."""
    for folder in Path(os.path.abspath(path)).parents:
        yield str(folder)
        if os.path.lexists(folder / ".git"):
            return


def _matches(folder: str, path: str) -> bool:
    patterns = _patterns(os.path.join(folder, ".gitignore"))
    if not patterns:
        return False
    import pathspec

    spec = pathspec.GitIgnoreSpec.from_lines(patterns)
    relative = os.path.relpath(os.path.abspath(path), folder)
    return spec.match_file(relative) or spec.match_file(relative + "/")


def _patterns(file: str) -> list[str]:
    if not os.path.isfile(file):
        return []
    try:
        with open(file, encoding="utf-8", errors="replace") as stream:
            return stream.read(_LARGEST).splitlines()
    except OSError:
        return []
