"""What a run asks of the disk. While it is recorded, each question is kept with its answer.

Only these functions and ``reading`` look at the tree, so that nothing decides over a finding without being recorded.
"""

from __future__ import annotations

import contextlib
import fnmatch
import os
import re
from collections.abc import Iterator

from bringup_lint.discover.record import Record

Path = str | os.PathLike[str]
_record: Record | None = None


@contextlib.contextmanager
def recorded() -> Iterator[Record]:
    """Keep every question that is asked meanwhile."""
    global _record
    before, _record = _record, Record()
    try:
        yield _record
    finally:
        _record = before


@contextlib.contextmanager
def unrecorded() -> Iterator[None]:
    """Keep nothing meanwhile: the caller says what it learned."""
    global _record
    before, _record = _record, None
    try:
        yield
    finally:
        _record = before


def depends_on_more() -> None:
    """Note that the run depends on what nobody records: the code of a user's rule, standard input, time."""
    if _record is not None:
        _record.is_whole = False


def opened(question: str, path: str, status: os.stat_result | OSError, data: bytes | None = None) -> None:
    """Note what was read of a file."""
    if _record is not None:
        _record.text(question, path, status, data)


def absolute(path: str) -> str:
    """A path from ``/`` on, without ``.`` and empty parts."""
    return tidied(os.path.join(os.getcwd(), path))


def tidied(path: str) -> str:
    """A path without ``.`` and empty parts, but for one with ``..``: what is before that may be a link."""
    return path if ".." in path.split("/") else os.path.normpath(path)


def above(path: str) -> Iterator[str]:
    """The folders that a path lies in, the nearest first."""
    folder = os.path.dirname(path)
    while folder != path:
        yield folder
        path, folder = folder, os.path.dirname(folder)


def lexists(path: Path) -> bool:
    _note(path)
    return os.path.lexists(path)


def exists(path: Path) -> bool:
    _note(path, follow=True)
    return os.path.exists(path)


def isdir(path: Path) -> bool:
    _note(path, follow=True)
    return os.path.isdir(path)


def isfile(path: Path) -> bool:
    _note(path, follow=True)
    return os.path.isfile(path)


def islink(path: Path) -> bool:
    _note(path)
    return os.path.islink(path)


def readlink(path: str) -> str:
    """Raises OSError."""
    _note(path)
    return os.readlink(path)


def realpath(path: Path) -> str:
    _note(path, follow=True)
    return os.path.realpath(path)


def stat(path: str) -> os.stat_result:
    """Raises OSError."""
    _note(path, follow=True)
    return os.stat(path)


def scandir(folder: str) -> list[os.DirEntry[str]]:
    """The entries of a folder, by their names. Raises OSError."""
    _note_listing(folder)
    with os.scandir(folder) as iterator:
        return sorted(iterator, key=lambda entry: entry.name)


def listdir(folder: Path) -> list[str]:
    """The names in a folder, in their order. Raises OSError."""
    _note_listing(folder)
    return sorted(os.listdir(folder))


def walk(folder: str) -> Iterator[tuple[str, list[str], list[str]]]:
    """As ``os.walk``."""
    for here, folders, names in os.walk(folder):
        _note_listing(here)
        yield here, folders, names


def matches(pattern: str) -> bool:
    """Whether a shell pattern matches a path (glob(7), as ``glob.iglob`` reads it)."""
    at = "/" if pattern.startswith("/") else os.getcwd()
    return _any(at, pattern.lstrip("/").split("/"))


def _any(at: str, parts: list[str]) -> bool:
    """Whether a path below ``at`` is matched by the parts of a pattern."""
    if not parts:
        return lexists(at)
    part, *others = parts
    if not part and not others:
        return isdir(at)
    if not re.search(r"[*?[]", part):
        return _any(os.path.join(at, part), others)
    try:
        names = listdir(at)
    except OSError:
        return False
    shown = names if part.startswith(".") else [name for name in names if not name.startswith(".")]
    return any(_any(os.path.join(at, name), others) for name in fnmatch.filter(shown, part))


def _note(path: Path, *, follow: bool = False) -> None:
    if _record is not None:
        _record.node(os.fspath(path), follow=follow)


def _note_listing(folder: Path) -> None:
    if _record is not None:
        _record.listing(os.fspath(folder))
