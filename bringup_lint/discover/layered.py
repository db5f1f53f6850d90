"""A tree whose files lie in tar archives, or in several folders of which a later one counts in place of an earlier one,
as the layers of an image do. Nothing is extracted: what an archive holds stays in memory.
"""

from __future__ import annotations

import fnmatch
import os
import posixpath
import tarfile
from collections.abc import Callable
from collections.abc import Iterable
from collections.abc import Iterator
from collections.abc import Mapping
from functools import cached_property

from bringup_lint.dataclass import dataclass
from bringup_lint.dataclass import field
from bringup_lint.discover import disk
from bringup_lint.discover.kinds import HEAD_SIZE
from bringup_lint.discover.kinds import kind_of
from bringup_lint.discover.reading import SIZE_LIMIT
from bringup_lint.discover.reading import Unreadable
from bringup_lint.discover.reading import decode
from bringup_lint.discover.reading import read_bytes
from bringup_lint.discover.roots import PASSED_OVER
from bringup_lint.discover.roots import VENDOR_FOLDERS
from bringup_lint.discover.tree import Tree
from bringup_lint.discover.tree import display_name
from bringup_lint.discover.tree import is_below
from bringup_lint.discover.walk import SKIPPED_FOLDERS
from bringup_lint.discover.walk import walk
from bringup_lint.pattern import regex
from bringup_lint.source import Source

MOST_MEMBERS = 500_000
MOST_KEPT = 256 * 1024 * 1024
"""Bytes of an archive that are kept; programs and libraries are passed over."""
MOST_READ = 4 * 1024 * 1024 * 1024
"""Bytes of an archive, unpacked, that are read at all."""
LONGEST_HEADER = 1024 * 1024
_HOPS = 20
_PACKED = regex(r"\.(?:tgz|tar\.(?:gz|xz|bz2))\Z")
_HEADERS = (tarfile.GNUTYPE_LONGNAME, tarfile.GNUTYPE_LONGLINK, tarfile.XHDTYPE, tarfile.XGLTYPE)


class BadArchive(ValueError):
    """An archive that is damaged, or bigger than what is read."""


@dataclass(frozen=True)
class Entry:
    """A file or link of a layer."""

    path: str
    """Absolute: the layer, and the place in it."""
    mode: int = 0o644
    data: bytes | None = None
    """Of an archive's file; None when it lies on the disk, or is too big to be read."""
    link: str | None = None
    size: int = 0
    on_disk: bool = False


class _Header(tarfile.TarInfo):
    """Refuses headers of megabytes, which would be read into memory whole."""

    def _proc_member(self, tar: tarfile.TarFile) -> tarfile.TarInfo:
        if self.type in _HEADERS and self.size > LONGEST_HEADER:
            raise tarfile.ReadError("a header of more than 1 MiB")
        return super()._proc_member(tar)  # type: ignore[misc]


def archive_entries(path: str) -> dict[str, Entry]:
    """Place in the archive -> file or link. Raises BadArchive."""
    entries: dict[str, Entry] = {}
    kept = read = 0
    try:
        with tarfile.open(path, "r|*", tarinfo=_Header) as archive:
            for member in archive:
                read += member.size
                name = _inner(member.name)
                if len(entries) > MOST_MEMBERS or read > MOST_READ:
                    raise BadArchive(f"{path}: holds more than is read of an archive")
                if name is None:
                    continue
                entry = _entry(archive, member, os.path.join(top_of(path), name), entries)
                if entry is not None:
                    entries[name] = entry
                    kept += len(entry.data or b"")
                if kept > MOST_KEPT:
                    raise BadArchive(f"{path}: holds more than {MOST_KEPT // 1024 // 1024} MiB of configuration")
    except (tarfile.TarError, EOFError, OSError, ValueError, OverflowError) as error:
        if isinstance(error, BadArchive):
            raise
        raise BadArchive(f"{path}: not a tar archive, or a damaged one ({error})") from error
    return entries


def _entry(archive: tarfile.TarFile, member: tarfile.TarInfo, path: str, known: dict[str, Entry]) -> Entry | None:
    if member.issym():
        return Entry(path, link=member.linkname)
    if member.islnk():
        target = known.get(_inner(member.linkname) or "")
        return target and Entry(path, target.mode, target.data, size=target.size)
    if not member.isfile():
        return None
    data = None
    if member.size <= SIZE_LIMIT and not _is_passed_over(_inner(member.name) or ""):
        file = archive.extractfile(member)
        data = file.read() if file is not None else None
    return Entry(path, member.mode & 0o7777, data, size=member.size)


def top_of(layer: str) -> str:
    """The absolute folder that a layer stands for; of an archive its name without what says how it is packed, because
    ``gz`` in a path says simulation."""
    top = os.path.abspath(layer)
    return top if disk.isdir(top) else _PACKED.sub(".tar", top)


def _inner(name: str) -> str | None:
    """A place in the archive without ``./``; None when it leads out."""
    parts = [part for part in name.split("/") if part not in ("", ".")]
    return None if not parts or ".." in parts else "/".join(parts)


def _is_passed_over(name: str) -> bool:
    folders = {name[:at] for at, sign in enumerate(name) if sign == "/"}
    return bool(folders & PASSED_OVER) and not folders & set(VENDOR_FOLDERS)


def folder_entries(folder: str, excluded: Callable[[str], bool]) -> dict[str, Entry]:
    top = os.path.abspath(folder)
    found = {}
    for path in walk(top, excluded):
        link = disk.readlink(path) if disk.islink(path) else None
        found[os.path.relpath(path, top)] = Entry(path, link=link, on_disk=True)
    return found


@dataclass(eq=False)
class LayeredTree(Tree):
    """Answers from its entries what a tree asks the disk."""

    places: dict[str, Entry] = field(default_factory=dict)
    """Place in the tree, without a leading slash -> what counts there."""

    @cached_property
    def by_path(self) -> dict[str, tuple[str, Entry]]:
        return {entry.path: (place, entry) for place, entry in self.places.items()}

    @cached_property
    def folders(self) -> frozenset[str]:
        """The absolute paths of all folders."""
        found: set[str] = set(self.tops)
        for path in self.by_path:
            folder = os.path.dirname(path)
            while folder not in found and folder != "/":
                found.add(folder)
                folder = os.path.dirname(folder)
        return frozenset(found)

    def holds(self, path: str) -> bool:
        return is_below(os.path.abspath(path), self.tops)

    def resolved(self, path: str) -> Entry | None:
        """The file at a path or behind the links there; None when they lead out or nowhere."""
        place, entry = self.by_path.get(path, ("", None))
        for _ in range(_HOPS):
            if entry is None or entry.link is None:
                return entry
            place = posixpath.normpath(posixpath.join("/", posixpath.dirname(place), entry.link)).lstrip("/")
            entry = self.places.get(place)
        return None

    def _text(self, path: str, source: Source) -> tuple[str, str]:
        named = self.by_path.get(path)
        if named is not None and named[1].link is not None:
            source.link = named[1].link
        entry = self.resolved(path)
        if entry is None:
            return "", ""
        return decode(self.data(entry))

    @staticmethod
    def data(entry: Entry) -> bytes:
        """Raises Unreadable."""
        if entry.on_disk:
            return read_bytes(entry.path)[0]
        if entry.data is None:
            raise Unreadable(f"{entry.size / 1024 / 1024:.0f} MiB of an archive, which are not read")
        return entry.data

    def exists(self, path: str) -> bool:
        return not self.holds(path) or path in self.by_path or path in self.folders

    def matches(self, pattern: str) -> bool:
        if not self.holds(pattern):
            return True
        names = (*self.by_path, *self.folders)
        parts = pattern.count("/")
        return any(name.count("/") == parts and fnmatch.fnmatchcase(name, pattern) for name in names)

    def is_file(self, path: str) -> bool:
        return self.resolved(path) is not None

    def is_link(self, path: str) -> bool:
        return path in self.by_path and self.by_path[path][1].link is not None

    def is_executable(self, path: str) -> bool:
        entry = self.resolved(path)
        if entry is not None and entry.on_disk:
            return super().is_executable(entry.path)
        return entry is None or bool(entry.mode & 0o111)

    def is_broken(self, path: str) -> bool:
        link = self.by_path[path][1].link if path in self.by_path else None
        return link is not None and not link.startswith("/") and self.resolved(path) is None

    def head(self, path: str, size: int) -> str:
        entry = self.resolved(path)
        try:
            return "" if entry is None else self.data(entry)[:size].decode("utf-8", errors="replace")
        except Unreadable:
            return ""

    def names_below(self, folder: str, depth: int) -> Iterator[str]:  # type: ignore[override]
        for path in self.by_path:
            if is_below(path, (folder,)) and path.count("/") - folder.count("/") <= depth + 1:
                yield os.path.basename(path)

    def tracked(self, path: str) -> bool | None:
        return None

    @staticmethod
    def is_ignored(path: str) -> bool:
        return False

    @staticmethod
    def real_path(path: str) -> str:
        return os.path.abspath(path)


def layered(layers: Iterable[str], tops: Iterable[str], excluded: Callable[[str], bool]) -> LayeredTree:
    """The tree of several folders and archives; ``tops`` are the folders at the top of a robot. Raises BadArchive."""
    layers = list(layers)
    places: dict[str, Entry] = {}
    for layer in layers:
        found = folder_entries(layer, excluded) if disk.isdir(layer) else archive_entries(layer)
        places.update(found)
    layers = [top_of(layer) for layer in layers]
    present = {place.partition("/")[0] for place in places}
    deploy = {os.path.join(layer, top): f"/{top}" for layer in layers for top in tops if top in present}
    tree = LayeredTree(asked=tuple(layers), tops=tuple(layers), deploy=deploy, places=places)
    for _, entry in sorted(places.items()):
        if not SKIPPED_FOLDERS.intersection(entry.path.split("/")) and not excluded(entry.path):
            _take_in(tree, entry)
    tree.sources.sort(key=lambda source: source.name)
    return tree


def copied(files: Mapping[str, str]) -> LayeredTree:
    """The tree of single files that are copied to a robot: their places there, and their absolute paths. It has no
    sources; what is asked for is read."""
    places = {place.lstrip("/"): Entry(path, on_disk=True) for place, path in files.items()}
    return LayeredTree(asked=("/",), tops=tuple(dict.fromkeys(files.values())), places=places)


def _take_in(tree: LayeredTree, entry: Entry) -> None:
    place = tree.by_path[entry.path][0]
    if _is_passed_over(place):
        return
    tree.remember(entry.path)
    kind = kind_of(display_name(entry.path), lambda: tree.head(entry.path, HEAD_SIZE))
    masks = kind.startswith("systemd") or (kind == "udev-rules" and entry.link == "/dev/null")
    if not kind or (entry.link is not None and not masks):
        return
    source = tree.read(entry.path, kind, judged=not place.startswith(VENDOR_FOLDERS), is_walked=True)
    if source is not None:
        tree.sources.append(source)
