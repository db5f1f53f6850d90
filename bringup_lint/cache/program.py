"""Which program gave an answer: its version and files, the rules, Python, the installed libraries, and the day."""

from __future__ import annotations

import contextlib
import marshal
import os
import sys
import time
from collections.abc import Iterator
from operator import attrgetter

from bringup_lint import __version__
from bringup_lint.digest import blake2b
from bringup_lint.discover.record import content

_PACKAGE = os.path.dirname(os.path.dirname(os.path.abspath(__file__)))
_MADE_BY_PYTHON = "__pycache__"
_FORMAT = 2
"""Of marshal, which writes the numbers of all files in half the time of making them decimal: the last format in which
equal lists are equal bytes."""
_STEP = 1 << 16
"""Bytes that are read at a time; nearly every file of the program is smaller."""


Mark = str | int
"""A name, a digest, or a number of a file."""


def program(*, by_content: bool) -> str:
    """A digest that is another one after any change that could change an answer. By content, it is the same on another
    machine with the same files."""
    return blake2b(marshal.dumps(_marks(by_content), _FORMAT), digest_size=16).hexdigest()


def _marks(by_content: bool) -> list[Mark]:
    """The day counts because certificates expire."""
    marks: list[Mark] = [__version__, sys.version, str(sys.flags), time.strftime("%Y-%m-%d")]
    for folder in (_PACKAGE, os.path.join(os.path.dirname(_PACKAGE), "rules")):
        marks += _files(folder, by_content)
    for folder in sys.path:
        marks.append(folder)
        marks += _names(folder) if by_content else _times(folder)
    return marks


def _files(top: str, by_content: bool) -> list[Mark]:
    """Every file below a folder, in the order of its names."""
    marks: list[Mark] = []
    folders = [top]
    for folder in folders:
        marks.append(folder)
        for entry in _entries(folder):
            if entry.is_dir(follow_symlinks=False):
                if entry.name != _MADE_BY_PYTHON:
                    folders.append(entry.path)
            elif by_content:
                marks += (entry.name, *_content(entry.path))
            else:
                status = entry.stat(follow_symlinks=False)
                marks += (entry.name, status.st_ino, status.st_size, status.st_mtime_ns, status.st_ctime_ns)
    return marks


def _entries(folder: str) -> list[os.DirEntry[str]]:
    try:
        with os.scandir(folder) as entries:
            return sorted(entries, key=attrgetter("name"))
    except OSError:
        return []


def _content(path: str) -> Iterator[str]:
    """Read without a buffer: to make one takes as long as to read a rule."""
    with contextlib.suppress(OSError):
        descriptor = os.open(path, os.O_RDONLY | getattr(os, "O_CLOEXEC", 0))
        try:
            yield blake2b(content(descriptor, _STEP, sys.maxsize), digest_size=16).hexdigest()
        finally:
            os.close(descriptor)


def _times(path: str) -> Iterator[str]:
    """Of a folder too: a library that is installed, renewed or removed changes the names in it."""
    with contextlib.suppress(OSError):
        status = os.stat(path)
        yield f"{status.st_ino} {status.st_size} {status.st_mtime_ns} {status.st_ctime_ns}"


def _names(folder: str) -> Iterator[str]:
    """The names of the installed libraries hold their versions (``dist-info``)."""
    with contextlib.suppress(OSError):
        yield from sorted(name for name in os.listdir(folder) if name != _MADE_BY_PYTHON)
