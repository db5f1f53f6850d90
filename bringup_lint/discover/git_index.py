"""The index of a git repository: the paths that the next commit holds (gitformat-index(5), versions 2 to 4)."""

from __future__ import annotations

import contextlib
import os
from collections.abc import Callable
from collections.abc import Iterator
from functools import lru_cache

from bringup_lint.discover import disk
from bringup_lint.discover.reading import Unreadable
from bringup_lint.discover.reading import read_bytes
from bringup_lint.discover.reading import read_head
from bringup_lint.discover.record import TRACKED

SIZE_LIMIT = 64 * 1024 * 1024
"""Bytes; about 600,000 files."""
_LONGEST = 4096
"""Bytes of a path (PATH_MAX)."""
_GROWTH = 8
"""How many times as long as an index, which leaves out what a path shares with the one before, its paths may be."""
_HEADER = 12
_STATUS = 40
"""Bytes of times, device, inode, mode, owner and size, which precede the hash of an entry."""
_HASHES = (20, 32)
"""Bytes of a SHA-1 and of a SHA-256; the index does not say which of them its repository uses."""
_EXTENDED = 0x4000
_LENGTH = 0x0FFF
_SPLIT = b"link"


class UnknownFormat(Exception):
    """The index cannot be read, or does not list all paths."""


def index_of(folder: str) -> str | None:
    """The index of the repository whose top a folder is; None when it is not the top of one."""
    git = os.path.join(folder, ".git")
    if disk.isdir(git):
        return os.path.join(git, "index")
    line = read_head(git, _LONGEST).strip()
    if not line.startswith("gitdir:"):
        return None
    place = os.path.normpath(os.path.join(folder, line.removeprefix("gitdir:").strip()))
    return os.path.join(place, "index") if _belongs(place, folder) else None


def _belongs(place: str, folder: str) -> bool:
    """Whether a git directory is the one of a working tree: it leads back (git-worktree(1)), or is the one that a
    repository around the tree keeps for its submodules. Any other place is none of the tree's business."""
    if "\0" in place:
        return False
    back = read_head(os.path.join(place, "gitdir"), _LONGEST).strip()
    if back and disk.realpath(os.path.join(place, back)) == disk.realpath(os.path.join(folder, ".git")):
        return True
    above = (os.path.join(parent, ".git") + os.sep for parent in _parents(folder))
    return any(place.startswith(each) for each in above)


def _parents(folder: str) -> Iterator[str]:
    while (parent := os.path.dirname(folder)) != folder:
        yield parent
        folder = parent


def read_index(path: str) -> frozenset[bytes]:
    """The tracked paths, from the top of the repository. Raises UnknownFormat."""
    with contextlib.suppress(Unreadable, UnknownFormat):
        with disk.unrecorded():
            data, status = read_bytes(path, SIZE_LIMIT)
        found, content = _read(data)
        disk.opened(TRACKED, path, status, content)
        return found
    try:
        return frozenset(tracked_paths(read_bytes(path, SIZE_LIMIT)[0]))
    except Unreadable as error:
        raise UnknownFormat(str(error)) from error


@lru_cache(1)
def _read(data: bytes) -> tuple[frozenset[bytes], bytes]:
    """The tracked paths, and what they say as one text. Kept for the next run of an editor: the index has not changed
    with the text that is edited."""
    found = frozenset(tracked_paths(data))
    return found, content_of(found)


def content_of(tracked: frozenset[bytes]) -> bytes:
    """What an index says, without the times of the files, which git renews whenever it looks at them."""
    return b"\0".join(sorted(tracked))


def tracked_only(folder: str) -> Callable[[str], bool]:
    """A test for paths (folders end in ``/``): is it a file that git does not track, in the repository around a folder?

    The index is the one that git names in its environment while it commits. Raises UnknownFormat."""
    for top in (folder, *_parents(folder)):
        index = index_of(top)
        if index is not None:
            index = os.environ.get("GIT_INDEX_FILE") or index
            known = read_index(index) if disk.lexists(index) else frozenset[bytes]()
            return lambda path: not path.endswith("/") and not _is_tracked(os.path.relpath(path, top), known)
    raise UnknownFormat(f"{folder} lies in no git repository")


def _is_tracked(path: str, known: frozenset[bytes]) -> bool:
    """Whether git tracks a file, or a submodule above it; what lies outside is not left out."""
    if path.startswith(".."):
        return True
    while path:
        if os.fsencode(path) in known:
            return True
        path = os.path.dirname(path)
    return False


def tracked_paths(data: bytes) -> list[bytes]:
    """The paths in an index. Raises UnknownFormat."""
    version = int.from_bytes(data[4:8], "big")
    if data[:4] != b"DIRC" or version not in (2, 3, 4):
        raise UnknownFormat(f"not an index of version 2, 3 or 4, but {version}")
    for hash_size in _HASHES:
        try:
            return _paths(data, version, hash_size)
        except (IndexError, ValueError):
            continue
    raise UnknownFormat("damaged")


def _paths(data: bytes, version: int, hash_size: int) -> list[bytes]:
    """Raises IndexError or ValueError for data of another form."""
    found: list[bytes] = []
    at, name, total = _HEADER, b"", 0
    for _ in range(int.from_bytes(data[8:12], "big")):
        start = at
        at += _STATUS + hash_size
        flags = int.from_bytes(data[at : at + 2], "big")
        at += 4 if flags & _EXTENDED else 2
        kept = b""
        if version == 4:
            dropped, at = _number(data, at)
            kept = name[: len(name) - dropped]
        end = data.index(b"\0", at)
        name = kept + data[at:end]
        if min(len(name), _LENGTH) != flags & _LENGTH or not name:
            raise ValueError("another hash, or damaged")
        total += len(name)
        if len(name) > _LONGEST or total > _GROWTH * len(data):
            raise ValueError("longer than any path")
        found.append(name)
        at = end + 1 if version == 4 else start + (end - start + 8) // 8 * 8
    if _SPLIT in _extensions(data, at, hash_size):
        raise UnknownFormat("a split index lists only part of the paths")
    return found


def _number(data: bytes, at: int) -> tuple[int, int]:
    """A number of variable width as in pack files, and where it ends."""
    byte = data[at]
    value = byte & 0x7F
    while byte & 0x80:
        at += 1
        byte = data[at]
        value = (value + 1) << 7 | byte & 0x7F
    return value, at + 1


def _extensions(data: bytes, at: int, hash_size: int) -> Iterator[bytes]:
    """The signatures of the extensions, which lie between the entries and the checksum. Raises ValueError."""
    end = len(data) - hash_size
    while at < end:
        yield data[at : at + 4]
        at += 8 + int.from_bytes(data[at + 4 : at + 8], "big")
    if at != end:
        raise ValueError("another hash, or damaged")
