"""The folders of a path that a file names, on the robot or in an image. A file can name a path of any length."""

from __future__ import annotations

import posixpath
from collections.abc import Iterator

_DEEPEST = 100
"""Folders of one path that are looked at: a robot has fewer."""


def joined(folder: str, path: str) -> str:
    """A path as it is meant in a folder, without ``.``, ``..`` and empty parts: Linux takes ``//`` for the root."""
    found = posixpath.normpath(posixpath.join(folder, path))
    return f"/{found.lstrip('/')}" if found.startswith("//") else found


def above(path: str) -> Iterator[str]:
    """The folders that a path lies in, the nearest first, without the root."""
    for _ in range(_DEEPEST):
        path = posixpath.dirname(path)
        if not path.strip("/"):
            return
        yield path
