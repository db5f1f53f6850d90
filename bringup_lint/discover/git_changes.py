"""Which files of a working tree are not as they were at a revision.

Git itself is not asked: the settings of the repository, which is not trusted, name programs that it would run (hooks,
fsmonitor, filters, textconv). dulwich reads refs, loose objects and packs, and runs none of them.
"""

from __future__ import annotations

import os
import stat
from collections.abc import Iterator
from typing import TYPE_CHECKING
from typing import Any
from typing import cast

from bringup_lint.discover import disk
from bringup_lint.discover.git_index import index_of
from bringup_lint.discover.reading import Unreadable
from bringup_lint.discover.reading import read_bytes
from bringup_lint.extras import installed_by

if TYPE_CHECKING:
    from dulwich.objects import Blob
    from dulwich.objects import Commit
    from dulwich.objects import Tree
    from dulwich.repo import Repo

DEPTH_LIMIT = 60
_MOST_FILES = 1_000_000
_SUBMODULE = 0o160000


class UnknownRevision(Exception):
    """The repository, the revision or dulwich is not there, or cannot be read."""


class Changes:
    """The working tree of a repository, compared with the point where its history left that of a revision."""

    def __init__(self, folder: str, revision: str) -> None:
        """Raises UnknownRevision."""
        disk.depends_on_more()
        self.top = _top(folder)
        self.note = ""
        """What a reader must know of the comparison; empty when it is exact."""
        self._known: dict[str, bool] = {}
        self._repository = _opened(self.top)
        try:
            self._base = self._merge_base(revision)
            self.gone = frozenset(os.path.basename(path) for path in self._deleted())
            """The names of the files that are not there any more, without folders."""
        except UnknownRevision:
            raise
        except Exception as error:  # what a damaged repository raises is not limited
            raise UnknownRevision(f"{self.top}: {_said(error)}") from error

    def touched(self, name: str) -> bool:
        """Whether a file (by a path from the working folder) is another than at the revision; what lies outside of the
        repository is not."""
        path = os.path.relpath(os.path.abspath(name), self.top)
        return not path.startswith("..") and self._differs(path)

    def _merge_base(self, revision: str) -> Commit:
        from dulwich.graph import find_merge_base

        head, other = (_commit(self._repository, each) for each in ("HEAD", revision))
        bases = find_merge_base(self._repository, [head.id, other.id])
        if not bases:
            self.note = f"no common commit with {revision} is here (a shallow clone?): compared with {revision} itself"
            return other
        found = self._repository[bases[0]]
        return _commit(self._repository, found.id.decode())

    def _deleted(self) -> Iterator[str]:
        for count, (path, _) in enumerate(_entries(self._repository, self._base.tree, "")):
            if count > _MOST_FILES:
                raise UnknownRevision(f"{self.top}: more than {_MOST_FILES} files")
            if not os.path.lexists(os.path.join(self.top, path)):
                yield path

    def _differs(self, path: str) -> bool:
        if path not in self._known:
            mode, blob = _found(self._repository, self.top, self._base.tree, path)
            self._known[path] = blob is None or not _is_same(os.path.join(self.top, path), mode, blob)
        return self._known[path]


def _top(folder: str) -> str:
    parents = [folder]
    while (parent := os.path.dirname(parents[-1])) != parents[-1]:
        parents.append(parent)
    top = next((each for each in parents if index_of(each) is not None), None)
    if top is None:
        raise UnknownRevision(f"{folder} lies in no git repository")
    return top


def _opened(top: str) -> Repo:
    """The repository of a working tree, whose git directory belongs to it. Raises UnknownRevision."""
    try:
        from dulwich.repo import Repo
    except ImportError as error:
        raise UnknownRevision(f"dulwich is not installed: {installed_by('git')}") from error
    index = index_of(top)
    if index is None:
        raise UnknownRevision(f"{top}: its git directory lies elsewhere")
    try:
        return Repo(top, controldir=os.path.dirname(index), worktree=top)
    except Exception as error:  # as above
        raise UnknownRevision(f"{top}: {_said(error)}") from error


def _said(error: Exception) -> str:
    return f"{type(error).__name__}: {error}" if str(error) else type(error).__name__


def _commit(repository: Repo, revision: str) -> Commit:
    """The commit that a name, a tag, a hash or ``NAME~1`` means. Raises UnknownRevision."""
    from dulwich.objects import Commit
    from dulwich.objects import Tag
    from dulwich.objectspec import parse_commit
    from dulwich.objectspec import parse_object

    found: Any = None
    for parse in (parse_commit, parse_object):
        try:
            found = parse(repository, revision)
            break
        except (KeyError, ValueError, NotImplementedError):
            continue
    while isinstance(found, Tag):
        found = repository[found.object[1]]
    if not isinstance(found, Commit):
        raise UnknownRevision(f"no commit is called '{revision}' here; a shallow clone may lack it")
    return found


def _entries(repository: Repo, tree: bytes, folder: str, depth: int = 0) -> Iterator[tuple[str, int]]:
    """The paths and modes below a tree; submodules as one entry."""
    for entry in cast("Tree", repository[tree]).items():
        path = os.path.join(folder, os.fsdecode(entry.path))
        if stat.S_ISDIR(entry.mode) and depth < DEPTH_LIMIT:
            yield from _entries(repository, entry.sha, path, depth + 1)
        else:
            yield path, entry.mode


def _found(repository: Repo, top: str, tree: bytes, path: str) -> tuple[int, bytes | None]:
    """The mode and the content of a path in a tree, also in a submodule of it; None where it holds none."""
    parts = path.split(os.sep)
    for at, part in enumerate(parts, 1):
        holder = cast("Tree", repository[tree])
        try:
            mode, hashed = holder[os.fsencode(part)]
        except KeyError:
            return 0, None
        if mode == _SUBMODULE:
            return _in_submodule(os.path.join(top, *parts[:at]), hashed, os.path.join(*parts[at:], ""))
        if not stat.S_ISDIR(mode):
            return (mode, cast("Blob", repository[hashed]).data) if at == len(parts) else (0, None)
        tree = hashed
    return 0, None


def _in_submodule(top: str, commit: bytes, path: str) -> tuple[int, bytes | None]:
    """What the commit holds that the repository around the submodule names; nothing where it is not here."""
    try:
        repository = _opened(top)
        return _found(repository, top, cast("Commit", repository[commit]).tree, path.rstrip(os.sep))
    except (KeyError, UnknownRevision):
        return 0, None


def _is_same(path: str, mode: int, blob: bytes) -> bool:
    """Whether a file or link is what a blob says; line ends may be those of the checkout."""
    if stat.S_ISLNK(mode) or os.path.islink(path):
        return os.path.islink(path) and stat.S_ISLNK(mode) and os.fsencode(os.readlink(path)) == blob
    try:
        data, _ = read_bytes(path)
    except Unreadable:
        return False
    return data == blob or data.replace(b"\r\n", b"\n") == blob.replace(b"\r\n", b"\n")
