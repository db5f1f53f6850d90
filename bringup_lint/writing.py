"""The one place that writes files: whole or not at all, and never through a link.

A file is replaced by a new one beside it, which gets a random name, and the mode, owner, group and extended attributes
(among them access control lists) of the old one before it gets any content. A file that other names lead to (hard
links), that is a symbolic link or no regular file, or whose owner cannot be kept, is left alone when a fix asks for it:
``NotWritten`` says why.
"""

from __future__ import annotations

import contextlib
import os
import signal
import stat
from collections.abc import Iterable
from collections.abc import Iterator

from bringup_lint.discover.reading import describe
from bringup_lint.discover.record import FLAGS
from bringup_lint.discover.record import NEW
from bringup_lint.named_tuple import NamedTuple
from bringup_lint.type_names import TYPE_CHECKING
from bringup_lint.type_names import BinaryIO

if TYPE_CHECKING:
    from pathlib import Path

_FOLDER = os.O_RDONLY | getattr(os, "O_DIRECTORY", 0) | getattr(os, "O_CLOEXEC", 0)
_READABLE_BY_ALL = 0o666
_OF_THE_CONTENT = frozenset({"security.capability", "security.evm", "security.ima"})
"""Extended attributes that are right for the old content only; the kernel drops or renews them."""


class NotWritten(Exception):
    """A file was not written, and is as it was; the text names it and says why."""

    def __init__(self, path: Path, why: str | Exception) -> None:
        self.path = path
        self.why = "is there already" if isinstance(why, FileExistsError) else _words(why)
        super().__init__(f"{path}: {self.why}")


def _words(why: str | Exception) -> str:
    return (isinstance(why, OSError) and why.strerror) or str(why)


class _Place(NamedTuple):
    """A name in a folder that stays the same folder, whatever is renamed above it."""

    name: str
    folder: int | None
    """The descriptor of the folder; None where the system has none, and ``name`` is a whole path."""

    def beside(self) -> _Place:
        """A random name in the same folder, short whatever this name is."""
        head, _, _ = self.name.rpartition(os.sep)
        return self._replace(name=os.path.join(head, f".bringup-lint-{os.urandom(8).hex()}"))


def create(path: Path, content: bytes) -> None:
    """Write a file that is not there yet. Raises NotWritten, also when it is there."""
    with _reported(path), _undisturbed(), _place(path) as place:
        with _new(place, _READABLE_BY_ALL) as file:
            _fill(file, content)
        _keep(place.folder)


def replace(path: Path, content: bytes | Iterable[bytes]) -> None:
    """Write a report, whole or in pieces: a new file, or one in the place of an old one. Raises NotWritten."""
    _refuse_linked_folder(path)
    with _reported(path), _undisturbed(), _place(path) as place:
        old = _status(place)
        if old is not None and not stat.S_ISREG(old.st_mode):
            raise NotWritten(path, f"it is {describe(old.st_mode)}, not a regular file")
        temporary = place.beside()
        with _new(temporary, _READABLE_BY_ALL if old is None else 0o600) as file:
            if old is not None:
                with contextlib.suppress(OSError):
                    os.fchown(file.fileno(), old.st_uid, old.st_gid)
                os.fchmod(file.fileno(), stat.S_IMODE(old.st_mode) & 0o777)
            _fill(file, content)
            os.replace(temporary.name, place.name, src_dir_fd=place.folder, dst_dir_fd=place.folder)
        _keep(place.folder)


def correct(path: Path, was: bytes, content: bytes) -> None:
    """Replace the content of a file that was read before, and change nothing else of it. Raises NotWritten."""
    with _reported(path), _undisturbed(), _place(path) as place, _opened(path, place) as old:
        status = os.fstat(old)
        if why := _refusal(status):
            raise NotWritten(path, why)
        temporary = place.beside()
        with _new(temporary, 0o600) as file:
            _take_over(path, old, status, file.fileno())
            _fill(file, content)
            if not _still(place, old, status, was):
                raise NotWritten(path, "it has changed since it was read")
            os.replace(temporary.name, place.name, src_dir_fd=place.folder, dst_dir_fd=place.folder)
        _keep(place.folder)


def _refusal(status: os.stat_result) -> str:
    """Why a file is not corrected; empty when nothing speaks against it."""
    if not stat.S_ISREG(status.st_mode):
        return f"it is {describe(status.st_mode)}, not a regular file"
    if status.st_nlink > 1:
        return f"it has {status.st_nlink} names (hard links), and the others would keep the old text"
    return ""


def _refuse_linked_folder(path: Path) -> None:
    """Raises NotWritten for a path below the working folder that a link leads out of it."""
    here = os.getcwd()
    folder = os.path.dirname(os.path.abspath(path))
    if not _is_below(folder, here):
        return
    if not _is_below(os.path.realpath(folder), os.path.realpath(here)):
        raise NotWritten(path, "a symbolic link leads out of the working folder")


def _is_below(path: str, folder: str) -> bool:
    return path == folder or path.startswith(folder.rstrip("/") + "/")


@contextlib.contextmanager
def _reported(path: Path) -> Iterator[None]:
    try:
        yield
    except (OSError, ValueError) as error:
        raise NotWritten(path, error) from error


@contextlib.contextmanager
def _undisturbed() -> Iterator[None]:
    """Let a signal that ends the program wait until a file is written: it would leave the new one beside the old."""
    if not hasattr(signal, "pthread_sigmask"):
        yield
        return
    before = signal.pthread_sigmask(signal.SIG_BLOCK, (signal.SIGINT, signal.SIGTERM, signal.SIGHUP))
    try:
        yield
    finally:
        signal.pthread_sigmask(signal.SIG_SETMASK, before)


@contextlib.contextmanager
def _place(path: Path) -> Iterator[_Place]:
    if os.open not in os.supports_dir_fd:
        yield _Place(os.path.abspath(path), None)
        return
    folder = os.open(path.parent, _FOLDER)
    try:
        yield _Place(path.name, folder)
    finally:
        os.close(folder)


def _status(place: _Place) -> os.stat_result | None:
    try:
        return os.stat(place.name, dir_fd=place.folder, follow_symlinks=False)
    except FileNotFoundError:
        return None


@contextlib.contextmanager
def _opened(path: Path, place: _Place) -> Iterator[int]:
    """The old file, open for reading."""
    status = _status(place)
    if status is not None and stat.S_ISLNK(status.st_mode):
        raise NotWritten(path, "it is a symbolic link, not a regular file")
    descriptor = os.open(place.name, FLAGS, dir_fd=place.folder)
    try:
        yield descriptor
    finally:
        os.close(descriptor)


@contextlib.contextmanager
def _new(place: _Place, mode: int) -> Iterator[BinaryIO]:
    """A new, empty file, which does not outlive a failure."""
    descriptor = os.open(place.name, NEW, mode, dir_fd=place.folder)
    try:
        with os.fdopen(descriptor, "wb") as file:
            yield file
    except BaseException:
        with contextlib.suppress(OSError):
            os.unlink(place.name, dir_fd=place.folder)
        raise


def _fill(file: BinaryIO, content: bytes | Iterable[bytes]) -> None:
    """Write everything to the disk, and close."""
    file.writelines([content] if isinstance(content, bytes) else content)
    file.flush()
    os.fsync(file.fileno())
    file.close()


def _keep(folder: int | None) -> None:
    """Write a folder to the disk, so that a new name in it outlives a loss of power."""
    if folder is not None:
        with contextlib.suppress(OSError):
            os.fsync(folder)


def _still(place: _Place, old: int, status: os.stat_result, was: bytes) -> bool:
    """Whether the name still leads to the file that was opened, and its content is what was read."""
    now = _status(place)
    if now is None or (now.st_dev, now.st_ino) != (status.st_dev, status.st_ino):
        return False
    with os.fdopen(os.dup(old), "rb") as file:
        return file.read(len(was) + 1) == was


def _take_over(path: Path, old: int, status: os.stat_result, new: int) -> None:
    """Owner, group, mode and extended attributes of a file. Raises NotWritten when one of them cannot be kept."""
    own = os.fstat(new)
    if (own.st_uid, own.st_gid) != (status.st_uid, status.st_gid):
        try:
            os.fchown(new, status.st_uid, status.st_gid)
        except OSError as error:
            raise NotWritten(path, f"its owner {status.st_uid}:{status.st_gid} would not stay") from error
    os.fchmod(new, stat.S_IMODE(status.st_mode))
    if not hasattr(os, "listxattr"):
        return
    try:
        _copy_attributes(old, new)
    except OSError as error:
        raise NotWritten(path, f"its extended attributes would not stay: {error.strerror}") from error


def _copy_attributes(old: int, new: int) -> None:
    before, now = _attributes(old), _attributes(new)
    for name in now.keys() - before.keys():
        os.removexattr(new, name)
    for name, value in before.items():
        if now.get(name) != value:
            os.setxattr(new, name, value)


def _attributes(descriptor: int) -> dict[str, bytes]:
    """The extended attributes of a file; none on a file system without them."""
    try:
        names = os.listxattr(descriptor)
    except OSError:
        return {}
    return {name: os.getxattr(descriptor, name) for name in names if name not in _OF_THE_CONTENT}
