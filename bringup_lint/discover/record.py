"""What a run has looked at, so that a later one can ask whether all of that is as it was.

A fact is what the run learned: the names in a folder, the digest of what it read, that nothing was there. A stamp is
the cheap sign that a fact still holds: inode, mode, owner, size and times. A stamp that differs proves nothing, and one
that agrees proves that nothing changed: the kernel sets the time of a change (ctime), which no program can set back.
Only a file that changed in the moment in which it was read could change again without a trace, so that such a young
stamp is not kept.
"""

from __future__ import annotations

import os
import stat
import time
from collections.abc import Iterator

from bringup_lint.digest import blake2b

YOUNG = 2_000_000_000
"""Nanoseconds. No file system counts times in larger steps (FAT: 2 s)."""
NODE, LISTING, HEAD, WHOLE, FOLLOWED = "nlhwf"
"""What was asked: what is at a path; the names in a folder; the first bytes of a file, all of it, or all of the file
behind a link. The last three come with a number of bytes."""
TRACKED = "t"
"""The paths in an index of git (``git_index``)."""
FLAGS = os.O_RDONLY | getattr(os, "O_NONBLOCK", 0) | getattr(os, "O_NOFOLLOW", 0) | getattr(os, "O_CLOEXEC", 0)
"""Never through a link, and without waiting for the other end of a FIFO."""
NEW = os.O_WRONLY | os.O_CREAT | os.O_EXCL | getattr(os, "O_NOFOLLOW", 0) | getattr(os, "O_CLOEXEC", 0)
"""Only where nothing is yet."""


Seen = tuple[str, str, str, str]
"""One look: the question, the absolute path, the stamp (empty when only the fact itself can tell), the fact. A named
tuple would load ``typing``, which takes longer than to look at all files of a robot."""


class Record:
    """Everything that a run looked at; each question is kept once."""

    def __init__(self) -> None:
        self._nodes: dict[str, Seen] = {}
        self._links: dict[str, str] = {}
        """Links that were not followed so far, and where they lead."""
        self._listings: dict[str, Seen] = {}
        self._texts: dict[tuple[str, str], Seen] = {}
        self._wholes: dict[str, Seen] = {}
        """Path -> the look at all of a file."""
        self.is_whole = True
        """Whether the run depends on this alone: on one state of the disk, and on nothing that is not a look at it."""

    def node(self, path: str, *, follow: bool) -> None:
        """A path was asked for, and with it every folder and every link on the way; ``follow`` says whether a link at
        its end counts as the way. Nobody looks where a link leads that is not followed."""
        pending = [(_absolute(path), follow)]
        while pending:
            path, follow = pending.pop()
            folder = os.path.dirname(path)
            if path not in self._nodes:
                status = _status(path, follow=False)
                self._nodes[path] = (NODE, path, _stamp(status, NODE), _fact(status))
                if isinstance(status, os.stat_result) and stat.S_ISLNK(status.st_mode):
                    self._links[path], fact = _link(path, status)
                    self._nodes[path] = (*self._nodes[path][:3], fact)
                if folder != path:
                    pending.append((folder, True))
            if follow and path in self._links:
                pending.append((os.path.join(folder, self._links.pop(path)), True))

    def listing(self, folder: str) -> None:
        """The names in a folder are about to be asked for."""
        self.node(folder, follow=True)
        folder = _absolute(folder)
        if folder not in self._listings:
            stamp = stamp_of(LISTING, folder)
            self._listings[folder] = (LISTING, folder, stamp, fact_of(LISTING, folder))

    def text(self, question: str, path: str, status: os.stat_result | OSError, data: bytes | None = None) -> None:
        """A file was opened: what it was, and what was read of it (None: nothing)."""
        self.node(path, follow=question.startswith(FOLLOWED))
        path = _absolute(path)
        seen = (question, path, _stamp(status, question), text_fact(status, data))
        before = self._texts.setdefault((question, path), seen)
        if question.startswith(WHOLE) and data is not None:
            self._wholes[path] = seen
        self.is_whole = self.is_whole and before[-1] == seen[-1]

    def __iter__(self) -> Iterator[Seen]:
        """Each look: folders and links before what is in them, so that who asks once more in this order and stops at
        the first change follows no link that was put there since."""
        opened = {path for _, path in self._texts}
        nodes = (self._nodes[path] for path in sorted(self._nodes))
        yield from (seen for seen in nodes if seen[1] not in opened or seen[-1].startswith(("l", "!")))
        yield from self._listings.values()
        yield from (seen for seen in self._texts.values() if not self._is_told_by_the_whole(seen))

    def _is_told_by_the_whole(self, seen: Seen) -> bool:
        """Whether the first bytes of a file say nothing that is not in the look at all of it, which was the same file
        at the same time."""
        question, path, stamp, _ = seen
        whole = self._wholes.get(path) if question.startswith(HEAD) else None
        return whole is not None and bool(stamp) and whole[2] == stamp


def stamp_of(question: str, path: str) -> str:
    """The stamp that a path has now; empty when it is too young to prove anything."""
    return _stamp(_status(path, follow=question != NODE), question)


def fact_of(question: str, path: str) -> str:
    """What the answer to a question is now."""
    if question == NODE:
        status = _status(path, follow=False)
        is_link = isinstance(status, os.stat_result) and stat.S_ISLNK(status.st_mode)
        return _link(path, status)[1] if is_link and isinstance(status, os.stat_result) else _fact(status)
    if question == LISTING:
        return _listed(path)
    return _read(question[0], path, int(question[1:]))


def _read(question: str, path: str, size: int) -> str:
    try:
        descriptor = os.open(path, FLAGS & ~getattr(os, "O_NOFOLLOW", 0) if question == FOLLOWED else FLAGS)
    except OSError as error:
        return _fact(error)
    try:
        status = os.fstat(descriptor)
        if not stat.S_ISREG(status.st_mode) or (question != HEAD and status.st_size > size):
            return text_fact(status, None)
        return text_fact(status, content(descriptor, status.st_size + 1, size))
    except OSError as error:
        return _fact(error)
    finally:
        os.close(descriptor)


def content(descriptor: int, step: int, limit: int) -> bytes:
    """All that a file holds up to a limit, read in steps of so many bytes: one, unless the file grows meanwhile. To ask
    for the limit at once would set as much memory aside for each file."""
    parts: list[bytes] = []
    left = limit
    while left and (part := os.read(descriptor, min(step, left))):
        parts.append(part)
        left -= len(part)
    return parts[0] if len(parts) == 1 else b"".join(parts)


def _listed(folder: str) -> str:
    status = _status(folder, follow=True)
    try:
        with os.scandir(folder) as entries:
            names = sorted(f"{_type(entry)}{entry.name}" for entry in entries)
    except OSError as error:
        return _fact(error)
    return _fact(status, os.fsencode("/".join(names)))


def _type(entry: os.DirEntry[str]) -> str:
    if entry.is_symlink():
        return "l"
    return "d" if entry.is_dir(follow_symlinks=False) else "f" if entry.is_file(follow_symlinks=False) else "s"


def _status(path: str, follow: bool) -> os.stat_result | OSError:
    try:
        return os.stat(path, follow_symlinks=follow)
    except OSError as error:
        return error
    except ValueError:
        return OSError()


def _link(path: str, status: os.stat_result) -> tuple[str, str]:
    """Where a link points, and the fact that it does."""
    try:
        target = os.readlink(path)
    except OSError as error:
        return "", _fact(error)
    return target, f"l{_fact(status, os.fsencode(target))}"


def _stamp(status: os.stat_result | OSError, question: str) -> str:
    if isinstance(status, OSError):
        return _fact(status)
    named = f"{status.st_dev} {status.st_ino} {status.st_mode} {status.st_uid} {status.st_gid}"
    if stat.S_ISDIR(status.st_mode) and question == NODE:
        return named
    if status.st_ctime_ns > time.time_ns() - YOUNG:
        return ""
    return f"{named} {status.st_size} {status.st_mtime_ns} {status.st_ctime_ns}"


def text_fact(status: os.stat_result | OSError, data: bytes | None) -> str:
    """The fact of what was read of a file, or of its size where it was too long to be read."""
    is_passed_over = data is None and isinstance(status, os.stat_result)
    return f"{_fact(status)} >{status.st_size}" if is_passed_over else _fact(status, data)  # type: ignore[union-attr]


def _fact(status: os.stat_result | OSError, data: bytes | None = None) -> str:
    """Mode, owner and the digest of what was read; the number of an error."""
    if isinstance(status, OSError):
        return f"!{status.errno}"
    named = f"{status.st_mode:o} {status.st_uid} {status.st_gid}"
    return named if data is None else f"{named} {blake2b(data, digest_size=16).hexdigest()}"


def _absolute(path: str) -> str:
    return path if path.startswith("/") else os.path.join(os.getcwd(), path)
