"""Which files git leaves out: those are made on the machine and can't be judged as missing."""

from __future__ import annotations

import os
from collections.abc import Iterator

from bringup_lint.discover import disk
from bringup_lint.discover.gitignore import Patterns
from bringup_lint.discover.reading import read_head

_LARGEST = 200_000
"""Bytes of a .gitignore that are read."""


def is_ignored(path: str) -> bool:
    """Whether a .gitignore between the file and the top of its repository names the file or a folder above it."""
    return any(_matches(folder, path) for folder in _folders(path))


def _folders(path: str) -> Iterator[str]:
    """The folders above a path, up to the top of the repository."""
    for folder in disk.above(os.path.abspath(path)):
        yield folder
        if disk.lexists(os.path.join(folder, ".git")):
            return


def _matches(folder: str, path: str) -> bool:
    lines = read_head(os.path.join(folder, ".gitignore"), _LARGEST).splitlines()
    if not lines:
        return False
    patterns = Patterns.of(lines)
    relative = os.path.relpath(os.path.abspath(path), folder)
    return patterns.match(relative) or patterns.match(relative + "/")
