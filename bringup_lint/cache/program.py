"""Which program gave an answer: its version and files, the rules, Python, the installed libraries, and the day."""

from __future__ import annotations

import contextlib
import os
import sys
import time
from collections.abc import Iterator

from bringup_lint import __version__
from bringup_lint.digest import blake2b
from bringup_lint.discover.record import content

_PACKAGE = os.path.dirname(os.path.dirname(os.path.abspath(__file__)))
_MADE_BY_PYTHON = "__pycache__"
_STEP = 1 << 16
"""Bytes that are read at a time; nearly every file of the program is smaller."""


def program(*, by_content: bool) -> str:
    """A digest that is another one after any change that could change an answer. By content, it is the same on another
    machine with the same files."""
    return blake2b(os.fsencode("\0".join(_words(by_content))), digest_size=16).hexdigest()


def _words(by_content: bool) -> Iterator[str]:
    """The day counts because certificates expire."""
    yield from (__version__, sys.version, str(sys.flags), time.strftime("%Y-%m-%d"))
    for folder in (_PACKAGE, os.path.join(os.path.dirname(_PACKAGE), "rules")):
        yield from _files(folder, by_content)
    for folder in sys.path:
        yield folder
        yield from _names(folder) if by_content else _times(folder)


def _files(folder: str, by_content: bool) -> Iterator[str]:
    """Every file below a folder, in the order of its names."""
    try:
        with os.scandir(folder) as iterator:
            entries = sorted(iterator, key=lambda entry: entry.name)
    except OSError:
        return
    for entry in entries:
        if entry.is_dir(follow_symlinks=False):
            if entry.name != _MADE_BY_PYTHON:
                yield from _files(entry.path, by_content)
        elif by_content:
            yield entry.path
            yield from _content(entry.path)
        else:
            status = entry.stat(follow_symlinks=False)
            yield f"{entry.path} {status.st_ino} {status.st_size} {status.st_mtime_ns} {status.st_ctime_ns}"


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
