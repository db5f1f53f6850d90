"""The folder of the cache: the user's own, closed to everybody else, and bounded.

It is opened once and then used by its descriptor, so that nobody can put another one in its place. Whatever is odd
about it, or about a file in it, is taken for a cache that holds nothing.
"""

from __future__ import annotations

import contextlib
import os
import stat
import time
from collections.abc import Iterator

from bringup_lint.discover.record import FLAGS
from bringup_lint.discover.record import NEW

NAME = "bringup-lint"
LARGEST = 32 * 1024 * 1024
"""Bytes of one entry."""
MOST = 256 * 1024 * 1024
"""Bytes of all entries; those that were used last stay."""
MOST_ENTRIES = 1000
KEY = "key"
_KEY_SIZE = 32
_PRIVATE = 0o700
_ABANDONED = 3600
"""Seconds after which a file that was never finished is removed."""


class Folder:
    """An open folder that belongs to this user alone."""

    def __init__(self, descriptor: int):
        self._descriptor = descriptor

    def read(self, name: str, limit: int = LARGEST) -> bytes | None:
        """The content of an entry, which is used now; None when there is none, or something else."""
        try:
            descriptor = os.open(name, FLAGS, dir_fd=self._descriptor)
        except OSError:
            return None
        try:
            status = os.fstat(descriptor)
            if not stat.S_ISREG(status.st_mode) or not _is_private(status) or status.st_size > limit:
                return None
            with contextlib.suppress(OSError):
                os.utime(descriptor)
            with os.fdopen(descriptor, "rb", closefd=False) as file:
                return file.read(limit)
        except OSError:
            return None
        finally:
            os.close(descriptor)

    def write(self, name: str, data: bytes) -> None:
        """Replace an entry, whole or not at all; what cannot be written is left out."""
        if len(data) > LARGEST:
            return
        unfinished = f".{os.urandom(8).hex()}"
        try:
            with os.fdopen(os.open(unfinished, NEW, 0o600, dir_fd=self._descriptor), "wb") as file:
                file.write(data)
            os.rename(unfinished, name, src_dir_fd=self._descriptor, dst_dir_fd=self._descriptor)
        except OSError:
            self._remove(unfinished)

    def key(self) -> bytes | None:
        """What the entries of this folder are sealed with; None when it cannot be kept."""
        if (known := self.read(KEY, _KEY_SIZE)) is None:
            self.write(KEY, os.urandom(_KEY_SIZE))
            known = self.read(KEY, _KEY_SIZE)
        return known if known and len(known) == _KEY_SIZE else None

    def tidy(self) -> None:
        """Remove what was used longest ago, until the rest is small enough."""
        total = 0
        with contextlib.suppress(OSError):
            for count, (name, status) in enumerate(sorted(self._entries(), key=lambda each: -each[1].st_mtime_ns), 1):
                total += status.st_size
                is_abandoned = name.startswith(".") and status.st_mtime < time.time() - _ABANDONED
                if is_abandoned or total > MOST or count > MOST_ENTRIES:
                    self._remove(name)

    def _entries(self) -> Iterator[tuple[str, os.stat_result]]:
        with os.scandir(self._descriptor) as entries:
            for entry in entries:
                with contextlib.suppress(OSError):
                    status = entry.stat(follow_symlinks=False)
                    if stat.S_ISREG(status.st_mode) and entry.name != KEY:
                        yield entry.name, status

    def _remove(self, name: str) -> None:
        with contextlib.suppress(OSError):
            os.unlink(name, dir_fd=self._descriptor)


@contextlib.contextmanager
def opened(*, create: bool) -> Iterator[Folder | None]:
    """The folder of this user; None when there is none and none may be made, or when it is not private."""
    descriptor = _descriptor(create)
    if descriptor is None:
        yield None
        return
    try:
        status = os.fstat(descriptor)
        is_ours = _is_private(status) and stat.S_IMODE(status.st_mode) == _PRIVATE
        yield Folder(descriptor) if is_ours else None
    finally:
        os.close(descriptor)


def _descriptor(create: bool) -> int | None:
    path = _place()
    if path is None:
        return None
    try:
        if create and not os.path.lexists(path):
            _make(path)
        return os.open(path, os.O_RDONLY | os.O_DIRECTORY | os.O_NOFOLLOW | os.O_CLOEXEC)
    except (OSError, ValueError):
        return None


def _place() -> str | None:
    """Below XDG_CACHE_HOME, else in ``.cache`` of HOME (XDG Base Directory Specification). None where these say
    nothing, where the system has no owners of files, and in a program that runs with the rights of another user."""
    if not hasattr(os, "geteuid") or os.geteuid() != os.getuid():
        return None
    base, home = os.environ.get("XDG_CACHE_HOME", ""), os.environ.get("HOME", "")
    if not os.path.isabs(base):
        base = os.path.join(home, ".cache")
    return os.path.join(base, NAME) if os.path.isabs(base) else None


def _make(path: str) -> None:
    """Make the folder, unless that would leave files of this user with another one: below the home of a user, root
    makes nothing. Raises OSError."""
    above = os.path.dirname(path)
    while not os.path.lexists(above):
        above = os.path.dirname(above)
    owner = os.stat(above).st_uid
    while owner == os.geteuid() and above != "/":
        above = os.path.dirname(above)
        if os.stat(above).st_uid not in (0, owner):
            raise PermissionError(f"{above} belongs to another user")
    if owner != os.geteuid():
        raise PermissionError(f"{above} belongs to another user")
    os.makedirs(path, _PRIVATE)


def _is_private(status: os.stat_result) -> bool:
    return status.st_uid == os.geteuid() and not status.st_mode & 0o077
