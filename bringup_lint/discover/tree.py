"""Tree: the files of one run, and what their absence can prove."""

from __future__ import annotations

import os
import re
import stat
from bisect import bisect_left
from collections.abc import Collection
from collections.abc import Iterable
from collections.abc import Iterator
from functools import cached_property
from functools import lru_cache

from bringup_lint.dataclass import dataclass
from bringup_lint.dataclass import field
from bringup_lint.dataclass import replace
from bringup_lint.discover import disk
from bringup_lint.discover.git_index import UnknownFormat
from bringup_lint.discover.git_index import index_of
from bringup_lint.discover.git_index import read_index
from bringup_lint.discover.held import Held
from bringup_lint.discover.held import over
from bringup_lint.discover.ignored import is_ignored
from bringup_lint.discover.reading import PROGRAM
from bringup_lint.discover.reading import Begun
from bringup_lint.discover.reading import Unreadable
from bringup_lint.discover.reading import begin
from bringup_lint.discover.reading import decode
from bringup_lint.discover.reading import read_bytes
from bringup_lint.discover.roots import overlay_path
from bringup_lint.discover.roots import resolve_inside
from bringup_lint.pattern import regex
from bringup_lint.source import Problem
from bringup_lint.source import Source
from bringup_lint.templates import template_language

_MOST_NAMES = 50_000
_MOST_TEXT = 32 << 20
"""Code points that are kept of files which nothing claims, and of those that something does."""
_SUBMODULE = regex(r"^[^\S\n]*path[^\S\n]*=[^\S\n]*(\S+)", re.M)
_ANY_ENCODING = frozenset({"cpp-driver", "cpp-node"})
"""Kinds that compilers read in whatever encoding their comments have."""
_ODD = ("//", "/./", "/../")
"""Parts of a path that is written in more than the shortest way."""
_AFTER_SLASH = chr(ord("/") + 1)
_PROGRAMS = frozenset({"", "shell-script"})
"""What commands name: a compiled program is as good as a script."""


@dataclass(eq=False)
class Tree:
    """What was walked, what of it was read, and the root it is on."""

    root: str | None = None
    """The root file system, or None in a repository."""
    complete: bool = False
    """Whether this is a whole root file system, so that what is not there is missing."""
    is_found: bool = False
    """Whether the root was recognized, and not named."""
    asked: tuple[str, ...] = ()
    """The absolute paths that the run was asked to judge; the rest of the tree is context."""
    tops: tuple[str, ...] = ()
    """The absolute folders that hold the tree. What lies elsewhere is not looked at."""
    closed: list[str] = field(default_factory=list)
    """What was met on the way through a root file system and another user could read."""
    excluded: Collection[str] = ()
    """What a configuration that was found in the tree leaves out: folders with a slash at the end, and files."""
    unknown: frozenset[str] = frozenset()
    """The names of sources that are taken for empty, because something failed on them."""
    deploy: dict[str, str] = field(default_factory=dict)
    """Path in the repository -> path on the robot, from the configuration."""
    written: set[str] = field(default_factory=set)
    """The paths on the robot of files whose text a script writes and is not wholly known: no file of the tree."""
    sources: list[Source] = field(default_factory=list)
    problems: list[Problem] = field(default_factory=list)
    held: Held | None = None
    """Unsaved texts and sources of an earlier run, in an editor."""
    _paths: dict[str, list[str]] = field(default_factory=dict)
    _walked: set[str] = field(default_factory=set)
    _in_order: list[str] = field(default_factory=list)
    _by_folder: dict[str, list[str]] = field(default_factory=dict)
    _absolute: list[tuple[str, str]] = field(default_factory=list)
    """The walked files in the order of their absolute paths, which come first."""
    _on_demand: dict[str, Source | None] = field(default_factory=dict)
    _by_reference: dict[str, Source | None] = field(default_factory=dict)
    _held: dict[str, bool] = field(default_factory=dict)
    _repositories: dict[str, tuple[str, str] | None] = field(default_factory=dict)
    """Folder -> top and index of the repository around it."""
    _indexes: dict[str, frozenset[bytes]] = field(default_factory=dict)
    _heads: dict[tuple[str, int], str] = field(default_factory=dict)
    _whole: dict[str, tuple[int, str]] = field(default_factory=dict)
    """Path -> the bytes of a file and its text, where the first bytes were all."""
    _indexed: int = 0
    """How many sources there were when these were filled:"""
    _placed: dict[str, list[Source]] = field(default_factory=dict)
    _named: dict[str, Source] = field(default_factory=dict)
    _there: dict[str, bool] = field(default_factory=dict)
    _inside: dict[str, str | None] = field(default_factory=dict)
    _texts: dict[str, Source] = field(default_factory=dict)
    """Path -> the file, as it was read first."""
    _shared: dict[tuple[str, str, bool], Source] = field(default_factory=dict)
    """Path, kind and whether it is judged -> the source that outlives the run."""
    _kept: int = 0
    _begun: Begun | None = None
    """The file of which the first bytes were asked for last: it is the next to be read."""

    def remember(self, path: str) -> None:
        """Keep the name of a file that was walked past, so that a reference to it can be resolved."""
        self._paths.setdefault(os.path.basename(path), []).append(path)
        self._walked.add(path)
        self._in_order.clear()
        self._by_folder.clear()
        self._absolute.clear()

    def without(self, names: Collection[str]) -> Tree:
        """The same tree, whose sources of these names are empty and of no kind; they are still there. What one file
        writes to another is left out, to be found again."""
        sources = (source for source in self.sources if source.origin is None)
        left = [replace(source, kind="", text="") if source.name in names else source for source in sources]
        return replace(
            self,
            sources=left,
            problems=list(self.problems),
            unknown=frozenset(names),
            written=set(),
            _texts={},
            _indexed=0,
            _placed={},
            _named={},
            _on_demand={},
            _by_reference={},
            _shared={},
        )

    def judges(self, path: str) -> bool:
        """Whether the run was asked for a path, or for a folder above it."""
        return is_below(os.path.abspath(path), self.asked)

    def holds(self, path: str) -> bool:
        """Whether a path lies in the tree, and no link on the way leads out of it."""
        folder = os.path.dirname(os.path.abspath(path))
        if folder not in self._held:
            self._held[folder] = is_below(folder, self.tops) and is_below(disk.realpath(folder), self._real_tops)
        return self._held[folder]

    @cached_property
    def _real_tops(self) -> tuple[str, ...]:
        return tuple(map(disk.realpath, self.tops))

    def read(self, path: str, kind: str = "", judged: bool | None = None, *, is_walked: bool = False) -> Source | None:
        """Read a file. It is judged when the run was asked for it, unless the caller knows better. What is wrong with
        one that was walked or named, and is judged, becomes a problem; which others are read depends on the rules."""
        judged = self.judges(path) if judged is None else judged
        known = None if judged else self._texts.get(path)
        if known is not None:
            return replace(known, kind=kind, judged=False)
        if not is_walked and (path, kind, judged) in self._shared:
            return self._shared[path, kind, judged]
        source = Source(display_name(path), kind=kind, robot_path=self.robot_path(path), judged=judged)
        if source.name in self.unknown:
            return replace(source, kind="")
        try:
            source.text, complaint = self._text(path, source)
        except Unreadable as error:
            if error.is_denied and self.root is not None and path not in self.asked:
                self.closed += [source.name] * (judged and is_walked)
            elif judged and is_walked:
                self.problems.append(Problem("unreadable", source.whole, str(error)))
            return None
        if source.text or source.link is None:
            source.template = template_language(source.name, source.text)
        if self.held is not None:
            source = self._shared[path, kind, judged] = self.held.shared(source)
        is_program = complaint == PROGRAM and source.kind in _PROGRAMS
        is_expected = is_program or source.kind in _ANY_ENCODING
        if complaint and source.judged and is_walked and not is_expected:
            self.problems.append(Problem("encoding", source.whole, complaint))
        if self.held is None:
            self._keep(path, source)
        return source

    def _keep(self, path: str, source: Source) -> None:
        """Keep a text for the layers that ask for it again as context, as long as these are not too many."""
        self._kept += len(source.text)
        if self._kept <= _MOST_TEXT:
            self._texts[path] = source

    def _text(self, path: str, source: Source) -> tuple[str, str]:
        """The text of a file, and what was wrong with its encoding."""
        if disk.islink(path):
            source.link = disk.readlink(path)
            target = self._link_target(path)
            if target is None:
                return "", ""
            path = target
        shown = None if self.held is None else self.held.texts.get(path)
        if shown is not None and not disk.lexists(path):
            return shown, ""
        data, status = read_bytes(path, begun=self._begun)
        if self.root is not None and not (self._is_checkout and self.tracked(path)):
            source.mode = stat.S_IMODE(status.st_mode)
            source.uid, source.gid = status.st_uid, status.st_gid
        text, complaint = decode(data)
        return (text, complaint) if shown is None else (over(text, shown), "")

    def _link_target(self, path: str) -> str | None:
        """The file behind a link, if it lies inside the tree."""
        if self.root is not None:
            return self.inside("/" + os.path.relpath(path, self.root))
        target = disk.realpath(path)
        return target if target in self._walked else None

    def inside(self, robot_path: str) -> str | None:
        """What a path leads to in the root file system, as ``resolve_inside``; None where there is none."""
        if robot_path not in self._inside:
            self._inside[robot_path] = resolve_inside(self.root, robot_path) if self.root is not None else None
        return self._inside[robot_path]

    def robot_path(self, path: str) -> str | None:
        """Where the file lies on the robot: by the root, the deploy map, or an overlay that is shaped like one."""
        if self.root is not None:
            relative = _relative(path, self.root)
            return None if relative.startswith("..") else f"/{relative}"
        for prefix, place in self.deploy.items():
            prefix = prefix.rstrip("/")
            if path == prefix or path.startswith(prefix + "/"):
                return place.rstrip("/") + path[len(prefix) :]
        found = overlay_path(display_name(path))
        return found[1] if found else None

    def find(self, robot_path: str) -> Source | None:
        """The file at a path on the robot, read now if no kind had claimed it; None when it is missing or ambiguous."""
        if robot_path not in self._on_demand:
            self._on_demand[robot_path] = self._find(robot_path)
        return self._on_demand[robot_path]

    def _find(self, robot_path: str) -> Source | None:
        self._index()
        known = self._placed.get(robot_path, ())
        if len(known) == 1:
            return known[0]
        if known or robot_path in self.written:
            return None
        if self.root is not None:
            path = self.inside(robot_path)
            return self.at(path) if path and disk.isfile(path) else None
        walked = self._by_suffix(robot_path)
        return None if walked is None else self.at(walked)

    def place(self, source: Source, robot_path: str) -> None:
        """Note where a source is on the robot, which was not known before."""
        source.robot_path = robot_path
        self._indexed = 0

    def _index(self) -> None:
        """Know the sources by their names and places, as long as none comes later."""
        if self._indexed == len(self.sources):
            return
        self._indexed = len(self.sources)
        self._placed.clear()
        self._named.clear()
        for source in self.sources:
            self._named.setdefault(source.name, source)
            if source.robot_path is not None:
                self._placed.setdefault(source.robot_path, []).append(source)

    def at(self, path: str) -> Source | None:
        """The file at an absolute path of the tree, whoever asks and whatever led to it: one source, read once."""
        if path not in self._by_reference:
            name = display_name(path)
            self._index()
            self._by_reference[path] = self._named.get(name) or self.read(path)
        return self._by_reference[path]

    def _by_suffix(self, robot_path: str) -> str | None:
        """The one file of the repository that shares the longest tail with the path; None when several do."""
        parts = robot_path.strip("/").split("/")
        candidates = [path for path in self._paths.get(parts[-1], []) if not _is_anothers(path, parts)]
        for count in range(len(parts), 0, -1):
            tail = "/" + "/".join(parts[-count:])
            matching = [path for path in candidates if path.endswith(tail)]
            if matching:
                return matching[0] if len(matching) == 1 else None
        return None

    def beside(self, source: Source, path: str) -> Source | None:
        """The file at a path relative to the folder of another; None when the tree does not hold it."""
        absolute = os.path.normpath(os.path.join(os.path.dirname(source.absolute), path))
        if absolute not in self._walked:
            return None
        return self.at(absolute)

    def walked_in(self, folder: str) -> list[str]:
        """The walked files in a folder, an absolute path."""
        if not self._by_folder:
            for path in self.paths:
                self._by_folder.setdefault(os.path.dirname(path), []).append(path)
        return self._by_folder.get(folder, [])

    def walked_below(self, folder: str) -> list[str]:
        """The walked files in a folder, an absolute path, and in all folders below it."""
        if not self._absolute:
            self._absolute += sorted((os.path.abspath(path), path) for path in self.paths)
        first = bisect_left(self._absolute, (f"{folder}/",))
        last = bisect_left(self._absolute, (f"{folder}{_AFTER_SLASH}",))
        return [path for _, path in self._absolute[first:last]]

    def real_path(self, path: str) -> str:
        """The absolute path without links; links that lead nowhere, or out of the tree, stay as they are."""
        path = os.path.abspath(path)
        if not self.holds(path):
            return path
        real = disk.realpath(path)
        return real if self.holds(real) else path

    def exists(self, path: str) -> bool:
        """Whether there is a file, folder or link at a path of the tree, walked or not. Nobody looks for what lies
        outside: it is taken to be there."""
        if path not in self._there:
            self._there[path] = not self.holds(path) or disk.lexists(path)
        return self._there[path]

    def matches(self, pattern: str) -> bool:
        """Whether a path of the tree, walked or not, matches a shell pattern. What may lie outside is taken to be
        there."""
        certain = re.split(r"[*?[]", pattern, maxsplit=1)[0]
        inner = pattern[len(certain) :].split("/")
        return not self.holds(certain) or ".." in inner or disk.matches(pattern)

    def is_file(self, path: str) -> bool:
        """Whether there is a file, or a link to one of the tree."""
        if not self.holds(path):
            return False
        if ".." not in path and not disk.islink(path):
            return disk.isfile(path)
        return self.holds(disk.realpath(path)) and disk.isfile(path)

    def is_link(self, path: str) -> bool:
        return self.holds(path) and disk.islink(path)

    def is_executable(self, path: str) -> bool:
        """Whether the mode of a file lets somebody execute it."""
        try:
            return not self.is_file(path) or bool(disk.stat(path).st_mode & 0o111)
        except OSError:
            return True

    @cached_property
    def keeps_modes(self) -> bool:
        """Whether the checkout has executable files, so that the mode of a file is that of the repository."""
        scripts = (path for path in self.paths if path.endswith((".sh", ".bash", ".py")))
        return any(self.is_file(path) and self.is_executable(path) for path in scripts)

    def is_broken(self, path: str) -> bool:
        """Whether a link leads nowhere; what an absolute one leads to is known on the robot only, and nobody looks for
        what lies outside of the tree."""
        try:
            if not self.holds(path) or os.path.isabs(disk.readlink(path)):
                return False
        except OSError:
            return False
        return self.holds(disk.realpath(path)) and not disk.exists(path)

    @cached_property
    def submodules(self) -> list[str]:
        """The absolute paths of the submodules, which may be empty here."""
        modules = [(path, self.read(path, judged=False)) for path in self.named(".gitmodules")]
        return [
            os.path.join(os.path.dirname(path), name)
            for path, source in modules
            for name in _SUBMODULE.findall(source.text if source is not None else "")
        ]

    def head(self, path: str, size: int) -> str:
        """The first bytes of a regular file as text; empty when there is nothing to read, and for a link."""
        length, whole = self._whole.get(path, (size + 1, ""))
        if length <= size:
            return whole
        if (path, size) not in self._heads:
            self._heads[path, size] = text = self.start(path, size)
            begun, is_shown = self._begun, self.held is not None and path in self.held.texts
            if begun is not None and (begun.path, begun.size) == (path, size) and begun.is_all and not is_shown:
                self._whole[path] = (len(begun.data), text)
        return self._heads[path, size]

    def start(self, path: str, size: int) -> str:
        """The same, asked once."""
        shown = None if self.held is None else self.held.texts.get(path)
        if shown is not None:
            return shown[:size]
        if self._begun is None or (self._begun.path, self._begun.size) != (path, size):
            self._begun = begin(path, size)
        return self._begun.text

    @staticmethod
    def names_below(folder: str, depth: int) -> Iterator[str]:
        """The names of the files below a folder, walked or not, down to so many folders; of very many the first."""
        seen = 0
        for here, folders, names in disk.walk(folder):
            yield from names
            seen += len(names) + len(folders)
            if here.count("/") - folder.count("/") > depth or seen > _MOST_NAMES:
                return

    def tracked(self, path: str) -> bool | None:
        """Whether git knows a file, so that it goes with the repository; None outside of a repository, and in one to
        which nothing was added yet. What an index in an unknown format holds is not known to git here."""
        file = os.path.abspath(path)
        repository = self._repository_of(os.path.dirname(file))
        if repository is None:
            return None
        top, index = repository
        return os.fsencode(file.removeprefix(top).lstrip(os.sep)) in self._tracked_by(index)

    def _repository_of(self, folder: str) -> tuple[str, str] | None:
        """The top and the index of the innermost repository that holds a folder; None also where that has no index."""
        below: list[str] = []
        while folder not in self._repositories:
            below.append(folder)
            index, above = index_of(folder), os.path.dirname(folder)
            if index is not None or above == folder:
                known = index is not None and disk.lexists(index)
                self._repositories[folder] = (folder, index or "") if known else None
                break
            folder = above
        found = self._repositories[folder]
        self._repositories.update(dict.fromkeys(below, found))
        return found

    @cached_property
    def _is_checkout(self) -> bool:
        """Whether the root lies in a repository: what git tracks there has not the modes and owners that it has on the
        robot. A repository inside of a root, such as that of etckeeper in /etc, says nothing of that."""
        tops = (self.root, *disk.above(self.root)) if self.is_found and self.root is not None else ()
        return any(index_of(folder) is not None for folder in tops)

    @staticmethod
    def is_ignored(path: str) -> bool:
        """Whether git leaves a file out, there or not."""
        return is_ignored(path)

    def is_left_out(self, folder: str) -> bool:
        """Whether git leaves a folder out: a .gitignore names it, and git tracks other files but none of its. Unknown,
        which is False, where git tracks nothing: the files may come from an archive of a repository that holds them."""
        path = os.path.abspath(folder)
        repository = self._repository_of(os.path.dirname(path))
        if repository is None or not is_ignored(path):
            return False
        top, index = repository
        tracked = self._tracked_by(index)
        own = os.fsencode(path.removeprefix(top).lstrip(os.sep))
        return bool(tracked) and not any(name == own or name.startswith(own + b"/") for name in tracked)

    def _tracked_by(self, index: str) -> frozenset[bytes]:
        if index not in self._indexes:
            try:
                self._indexes[index] = read_index(index)
            except UnknownFormat:
                self._indexes[index] = frozenset()
        return self._indexes[index]

    def has(self, robot_path: str) -> bool | None:
        """Whether a file, folder or link is there on the robot; None when the tree cannot tell."""
        if self.root is not None and self.complete:
            folder, _, name = robot_path.rstrip("/").rpartition("/")
            inside = self.inside(folder)
            return inside is not None and disk.lexists(os.path.join(inside, name))
        return True if self.find(robot_path) is not None else None

    @property
    def paths(self) -> list[str]:
        """All walked paths, as the file system names them, also of files that no kind claims."""
        if not self._in_order:
            self._in_order += sorted(path for known in self._paths.values() for path in known)
        return self._in_order

    def like(self, pattern: re.Pattern[str]) -> list[str]:
        """The walked paths in which a pattern is found."""
        if pattern not in self._like:
            self._like[pattern] = [path for path in self.paths if pattern.search(path)]
        return self._like[pattern]

    def pages(self, pattern: re.Pattern[str], size: int) -> Iterator[str]:
        """The first bytes of each file whose path matches, of whatever kind, as text."""
        return (self.head(path, size) for path in self.like(pattern))

    def says(self, pages: re.Pattern[str], size: int, pattern: re.Pattern[str]) -> bool:
        """Whether one of these has a match of a pattern that a module holds; searched once for all that ask."""
        if (pages, pattern) not in self._said:
            self._said[pages, pattern] = any(map(pattern.search, self.pages(pages, size)))
        return self._said[pages, pattern]

    @cached_property
    def _said(self) -> dict[tuple[re.Pattern[str], re.Pattern[str]], bool]:
        """What ``says`` answered."""
        return {}

    @cached_property
    def _like(self) -> dict[re.Pattern[str], list[str]]:
        """What ``like`` answered."""
        return {}

    def under(self, folder: str) -> list[str]:
        """The paths on the robot of all walked files in a folder such as ``/etc/default``."""
        paths = (self.robot_path(path) for known in self._paths.values() for path in known)
        return sorted({path for path in paths if path and path.rpartition("/")[0] == folder.rstrip("/")})

    def entries(self, folder: str) -> list[str] | None:
        """The names in a folder of the robot, walked or not; None when the tree cannot tell."""
        if self.root is None or not self.complete:
            return None
        path = self.inside(folder)
        try:
            return disk.listdir(path) if path else []
        except OSError:
            return None

    def walks(self, path: str) -> bool:
        """Whether a path is one of the walked ones, as it is written."""
        return path in self._walked

    def named(self, basename: str) -> Iterator[str]:
        """All walked paths with this last component."""
        yield from self._paths.get(basename, ())


def is_below(path: str, folders: Iterable[str]) -> bool:
    """Whether a path is one of the folders, or lies below one."""
    return any(path == folder or path.startswith(folder.rstrip("/") + "/") for folder in folders)


def display_name(path: str) -> str:
    """A path as the user knows it: relative to the working folder when it lies below it."""
    relative = _relative(path, os.getcwd())
    return path if relative.startswith("..") else relative


@lru_cache(maxsize=8192)
def _relative(path: str, folder: str) -> str:
    """As ``os.path.relpath``, which takes both paths to pieces, also where one lies below the other as it is."""
    prefix = folder.rstrip("/") + "/"
    if path.startswith(prefix) and len(path) > len(prefix) and not any(odd in f"{path}/" for odd in _ODD):
        return path[len(prefix) :]
    return os.path.relpath(path, folder)


def _is_anothers(path: str, wanted: list[str]) -> bool:
    """Whether a file lies in a folder of snippets of some program, such as ``logrotate.d``, where the wanted one does
    not."""
    folder = path.split("/")[-2:-1]
    return bool(folder) and folder[0].endswith(".d") and folder != wanted[-2:-1]
