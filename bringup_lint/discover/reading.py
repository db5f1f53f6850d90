"""Reading one file of an untrusted tree: regular files only, bounded, never through a link that was swapped in."""

from __future__ import annotations

import contextlib
import os
import stat
from collections.abc import Iterator
from collections.abc import Mapping
from itertools import pairwise

from bringup_lint.discover.disk import opened
from bringup_lint.discover.record import FLAGS
from bringup_lint.discover.record import FOLLOWED
from bringup_lint.discover.record import HEAD
from bringup_lint.discover.record import WHOLE
from bringup_lint.discover.record import content
from bringup_lint.named_tuple import NamedTuple

SIZE_LIMIT = 8 * 1024 * 1024
"""Bytes. No configuration file of a robot comes near; a larger one is reported and not read."""


_STRIDE = 2000
_DIGITS = b"0123456789"


class Unreadable(Exception):
    """The file cannot be read; the text says why, for the user."""

    def __init__(self, why: str | OSError) -> None:
        super().__init__(why if isinstance(why, str) else why.strerror or str(why))
        self.is_denied = isinstance(why, PermissionError)
        """Whether another user could read it."""


_PROPOSED: dict[str, bytes] = {}


@contextlib.contextmanager
def proposed(texts: Mapping[str, bytes]) -> Iterator[None]:
    """Read files, by their absolute paths, as if they held something else: what fixes would make of them."""
    _PROPOSED.update(texts)
    try:
        yield
    finally:
        _PROPOSED.clear()


class Begun(NamedTuple):
    """The first bytes of a regular file."""

    path: str
    size: int
    """How many were asked for."""
    data: bytes = b""
    status: os.stat_result | None = None
    """None when there is nothing to read."""

    @property
    def text(self) -> str:
        return self.data.decode("utf-8", errors="replace")

    @property
    def is_all(self) -> bool:
        """Whether the file has no more."""
        if self.status is None or self.path in _PROPOSED:
            return False
        return self.status.st_size == len(self.data)


def read_head(path: str, size: int) -> str:
    """The first bytes of a regular file as text; empty when there is nothing to read."""
    return begin(path, size).text


def begin(path: str, size: int) -> Begun:
    """The first bytes of a regular file."""
    question = f"{HEAD}{size}"
    try:
        descriptor = os.open(path, FLAGS)
    except ValueError:
        return Begun(path, size)
    except OSError as error:
        opened(question, path, error)
        return Begun(path, size)
    try:
        status = os.fstat(descriptor)
        if not stat.S_ISREG(status.st_mode):
            opened(question, path, status)
            return Begun(path, size)
        data = _PROPOSED[path][:size] if path in _PROPOSED else os.read(descriptor, size)
        opened(question, path, status, data)
        return Begun(path, size, data, status)
    except OSError as error:
        opened(question, path, error)
        return Begun(path, size)
    finally:
        os.close(descriptor)


def read_bytes(
    path: str, limit: int = SIZE_LIMIT, *, follow: bool = False, begun: Begun | None = None
) -> tuple[bytes, os.stat_result]:
    """The content and status of a regular file. Raises Unreadable. Never blocks on a FIFO or device.

    ``follow`` takes a link for the file that it leads to: right for what the user names, not for what a tree holds.
    ``begun`` is what was read a moment ago: when it is all of this file, that is not opened again.
    """
    question = f"{FOLLOWED if follow else WHOLE}{limit}"
    if begun is not None and begun.status is not None and begun.path == path and begun.is_all:
        opened(question, path, begun.status, begun.data)
        return begun.data, begun.status
    try:
        descriptor = os.open(path, FLAGS & ~getattr(os, "O_NOFOLLOW", 0) if follow else FLAGS)
    except ValueError as error:
        raise Unreadable(str(error)) from error
    except OSError as error:
        opened(question, path, error)
        raise Unreadable(error) from error
    try:
        status = os.fstat(descriptor)
        if not stat.S_ISREG(status.st_mode) or status.st_size > limit:
            opened(question, path, status)
        if not stat.S_ISREG(status.st_mode):
            raise Unreadable(f"not a regular file but {describe(status.st_mode)}")
        if status.st_size > limit:
            raise Unreadable(
                f"{status.st_size / 1024 / 1024:.0f} MiB is more than the {limit // 1024 // 1024} MiB limit"
            )
        data = _PROPOSED[path] if path in _PROPOSED else content(descriptor, status.st_size + 1, limit)
        opened(question, path, status, data)
        return data, status
    except OSError as error:
        opened(question, path, error)
        raise Unreadable(error) from error
    finally:
        os.close(descriptor)


def describe(mode: int) -> str:
    """A file type in words."""
    for test, word in (
        (stat.S_ISDIR, "a directory"),
        (stat.S_ISFIFO, "a FIFO"),
        (stat.S_ISSOCK, "a socket"),
        (stat.S_ISCHR, "a character device"),
        (stat.S_ISBLK, "a block device"),
        (stat.S_ISLNK, "a symbolic link"),
    ):
        if test(mode):
            return word
    return "a special file"


def _has_endless_number(data: bytes) -> bool:
    """Whether so many digits follow each other that Python refuses to make a number of them (4,300). Linear: such a run
    covers two neighbours of the bytes that are looked at."""
    marks = data[::_STRIDE]
    return any(
        first in _DIGITS and second in _DIGITS and data[at * _STRIDE : (at + 1) * _STRIDE].isdigit()
        for at, (first, second) in enumerate(pairwise(marks))
    )


PROGRAM = "is a compiled program"
"""What ``decode`` says of one: no mistake where a command names it."""


def decode(data: bytes) -> tuple[str, str]:
    """The text and what was wrong with its encoding (empty when nothing). Undecodable bytes become U+FFFD."""
    if data.startswith((b"\xff\xfe", b"\xfe\xff")):
        return data.decode(
            "utf-16", errors="replace"
        ), "is UTF-16, which none of its readers understands; save it as UTF-8"
    if data.startswith(b"\x7fELF"):
        return "", PROGRAM
    if b"\0" in data:
        return "", "contains NUL bytes: it is binary or damaged"
    if _has_endless_number(data):
        return "", "holds a number of thousands of digits, which no program reads: it is damaged"
    try:
        return data.decode("utf-8"), ""
    except UnicodeDecodeError as error:
        line = data.count(b"\n", 0, error.start) + 1
        return data.decode("utf-8", errors="replace"), f"is not UTF-8: byte 0x{data[error.start]:02x} in line {line}"
