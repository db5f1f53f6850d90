"""Walking the paths of a run: which folders are entered, which files are looked at."""

from __future__ import annotations

import errno
import os
import stat
from collections.abc import Callable
from collections.abc import Collection
from collections.abc import Iterable
from collections.abc import Iterator

from bringup_lint.discover import disk
from bringup_lint.discover.held import Held
from bringup_lint.discover.kinds import HEAD_SIZE
from bringup_lint.discover.kinds import kind_of
from bringup_lint.discover.reading import decode
from bringup_lint.discover.reading import describe
from bringup_lint.discover.roots import PASSED_OVER
from bringup_lint.discover.roots import VENDOR_FOLDERS
from bringup_lint.discover.roots import is_root
from bringup_lint.discover.roots import resolve_inside
from bringup_lint.discover.roots import root_of
from bringup_lint.discover.tree import Tree
from bringup_lint.discover.tree import display_name
from bringup_lint.discover.tree import is_below
from bringup_lint.pattern import regex
from bringup_lint.source import Problem
from bringup_lint.source import Source
from bringup_lint.spelling import meant
from bringup_lint.templates import template_language

SKIPPED_FOLDERS = frozenset(
    {".git", ".hg", ".svn", ".tox", ".nox", ".venv", "venv", "node_modules", "__pycache__", ".mypy_cache", ".cache"}
)
IGNORE_MARKERS = frozenset({"COLCON_IGNORE", "AMENT_IGNORE"})
"""colcon leaves these in build/, install/ and log/, and people put them where nothing is to be built."""
_MADE_BY_COLCON = frozenset({".built_by", ".colcon_install_layout", "latest_build", "local_setup.bash"})
_COLCON_FOLDER = regex(r"(?:build|install|log)(?:[._-].*)?")
_OF_PACKAGES = frozenset(
    {
        "cmake",
        "cpp-driver",
        "cpp-node",
        "launch-python",
        "launch-ros1",
        "launch-xml",
        "launch-yaml",
        "params",
        "python-node",
        "ros-package",
        "setup-cfg",
        "setup-py",
    }
)
"""Kinds that only count where colcon builds: not in a folder that it ignores. An image, a unit or a playbook there is
used all the same."""

DEPTH_LIMIT = 60
_LEADS_OUT = "a symbolic link leads out of the tree; name the place that it leads to"

Excluded = Callable[[str], bool]


def discover(
    paths: Iterable[str],
    *,
    root: str | None = None,
    deploy: dict[str, str] | None = None,
    excluded: Excluded = lambda path: False,
    held: Held | None = None,
) -> Tree:
    """Read everything below the paths that some kind claims, and the vendor's folders beside a root's /etc as
    context."""
    paths = list(paths)
    tree = Tree(deploy=deploy or {}, held=held)
    if root is not None:
        tree.root = disk.absolute(root)
        tree.complete = True
        paths = [inside_resolved(tree.root, path) for path in paths]
    else:
        paths = [os.path.abspath(path) for path in paths]
        tree.root = next(filter(None, map(root_of, paths)), None)
        tree.complete = tree.root is not None and is_root(tree.root)
        tree.is_found = tree.root is not None
    tree.asked = tuple(paths)
    tree.tops = tuple(dict.fromkeys(map(_top_of, paths))) if tree.root is None else (tree.root,)
    walked: set[str] = set()
    ignored: set[str] = set()
    for path in paths:
        if leads_out(tree, path):
            _leave_out(tree, path, _LEADS_OUT)
            continue
        if not disk.isdir(path):
            _read_named(tree, path, walked)
            continue
        for file in walk(path, excluded, lambda folder, error: _unreadable(tree, folder, error), ignored=ignored):
            _read_walked(tree, file, walked, ignored, judged=not _is_vendor(tree, file, path))
    if tree.root is not None:
        _read_context(tree, walked, _context_folders(tree.root))
    else:
        files = [path for path in paths if not disk.isdir(path) and not leads_out(tree, path)]
        _read_context(tree, walked, sorted({top for path in files if (top := repository_of(path))}), excluded)
    tree.sources.sort(key=lambda source: source.name)
    return tree


def _context_folders(root: str) -> list[str]:
    """/etc and the vendor's folders; what lies behind a link (``/lib`` on a merged /usr) has another name there."""
    base = disk.realpath(root)
    plain = [
        folder for folder in VENDOR_FOLDERS if disk.realpath(os.path.join(root, folder)) == os.path.join(base, folder)
    ]
    return [os.path.join(root, folder) for folder in ("etc", *plain)]


def discover_text(name: str, data: bytes) -> Tree:
    """A tree of one file that comes from standard input."""
    path = os.path.abspath(name)
    tree = Tree(asked=(path,), tops=(_top_of(path),))
    text, complaint = decode(data)
    kind = kind_of(name, lambda: text[:HEAD_SIZE])
    source = Source(name, text, kind, robot_path=tree.robot_path(path))
    source.template = template_language(name, text)
    tree.sources.append(source)
    if complaint or not kind:
        tree.problems.append(Problem("encoding" if complaint else "unknown-kind", source.whole, complaint))
    return tree


def inside(root: str, path: str) -> str:
    """A path of the command line inside a mounted root: ``/etc`` and ``mnt/etc`` both mean the root's /etc."""
    absolute = os.path.abspath(path)
    if absolute == root or absolute.startswith(f"{root}/"):
        return absolute
    return os.path.join(root, path.lstrip("/"))


def inside_resolved(root: str, path: str) -> str:
    """The same, where the links of the mounted root lead, as they do on the system that boots from it; a link that is
    configuration itself stays one."""
    place = inside(root, path)
    relative = os.path.relpath(place, root)
    if relative.startswith("..") or not disk.islink(place) or kind_of_link(place):
        return place
    found = resolve_inside(root, relative)
    return place if found is None else os.path.join(root, os.path.relpath(found, disk.realpath(root)))


def missing(paths: Iterable[str], root: str | None) -> str:
    """What to say of the first path that does not exist; empty when all do."""
    for path in paths:
        place = os.path.abspath(path) if root is None else inside(disk.absolute(root), path)
        if not disk.lexists(place):
            near = meant(os.path.basename(place), _names_in(os.path.dirname(place)))
            there = os.path.join(os.path.dirname(path.rstrip("/")), near) if near else ""
            where = "" if root is None else f" in {root}"
            return f"there is no '{path}'{where}" + (f"; did you mean '{there}'?" if there else "")
    return ""


def _names_in(folder: str) -> list[str]:
    try:
        return disk.listdir(folder)
    except OSError:
        return []


def walk(
    top: str,
    excluded: Excluded = lambda path: False,
    failed: Callable[[str, OSError], None] = lambda path, error: None,
    depth: int = 0,
    ignored: set[str] | None = None,
) -> Iterator[str]:
    """All files and links below a folder, in the order of their names. Linked folders are not entered; ``failed`` is
    told of folders that cannot be, and ``ignored`` of those in which colcon builds nothing."""
    ignored = set() if ignored is None else ignored
    try:
        entries = disk.scandir(top)
    except OSError as error:
        failed(top, error)
        return
    names = {entry.name for entry in entries}
    if depth and names & IGNORE_MARKERS:
        if names & _MADE_BY_COLCON or _COLCON_FOLDER.fullmatch(os.path.basename(top)):
            return
        ignored.add(top)
    if "package.xml" in names and is_below(top, ignored):
        return
    if depth == 0 and is_root(top):
        excluded = _with_system_folders(excluded, top)
    for entry in entries:
        if entry.is_dir(follow_symlinks=False):
            if entry.name in SKIPPED_FOLDERS or excluded(entry.path + "/"):
                continue
            if depth < DEPTH_LIMIT:
                yield from walk(entry.path, excluded, failed, depth + 1, ignored)
            else:
                failed(entry.path, OSError(errno.ENAMETOOLONG, f"it is more than {DEPTH_LIMIT} folders deep"))
        elif not excluded(entry.path) and (entry.is_file(follow_symlinks=False) or entry.is_symlink()):
            yield entry.path


def _with_system_folders(excluded: Excluded, root: str) -> Excluded:
    folders = {os.path.join(root, folder) + "/" for folder in PASSED_OVER}
    return lambda path: path in folders or excluded(path)


def _read_walked(tree: Tree, path: str, walked: set[str], ignored: Collection[str] = (), judged: bool = True) -> None:
    if path in walked:
        return
    walked.add(path)
    tree.remember(path)
    kind = kind_of(display_name(path), lambda: tree.start(path, HEAD_SIZE))
    if not kind or (kind in _OF_PACKAGES and is_below(path, ignored)):
        return
    if disk.islink(path) and not _is_meant(tree, path, kind):
        return
    source = tree.read(path, kind, judged, is_walked=True)
    if source is not None:
        tree.sources.append(source)


def _is_meant(tree: Tree, path: str, kind: str) -> bool:
    """Whether a link says something of its own: links between units do, links to /dev/null mask udev rules, and in a
    root file system udev reads the file behind a link. Elsewhere a link only shows a file twice."""
    if kind == "udev-rules":
        return tree.root is not None or disk.readlink(path) == "/dev/null"
    return kind.startswith("systemd")


def _unreadable(tree: Tree, path: str, error: OSError) -> None:
    if isinstance(error, PermissionError) and tree.root is not None and path not in tree.asked:
        tree.closed.append(display_name(path))
    else:
        _leave_out(tree, path, error.strerror or str(error))


def _leave_out(tree: Tree, path: str, why: str) -> None:
    tree.problems.append(Problem("unreadable", Source(display_name(path)).whole, why))


def _top_of(path: str) -> str:
    """The folder that holds the tree of a path on the command line: the repository around it, else the working folder
    when it lies below that, else the path itself, or the folder of a file."""
    here = os.getcwd()
    near = here if is_below(path, (here,)) else path if disk.isdir(path) else os.path.dirname(path)
    return repository_of(os.path.join(path, "inside")) or near


def leads_out(tree: Tree, path: str) -> bool:
    """Whether a link on the way to a path of a tree leads out of it. A tree that a user names by a link is that one."""
    if path in tree.tops:
        return False
    if tree.root is not None:
        return disk.islink(path) and _leaves(path, tree.root)
    return any(is_below(path, (top,)) and _leaves(path, top) for top in tree.tops)


def _leaves(path: str, top: str) -> bool:
    return not is_below(disk.realpath(path), (disk.realpath(top),))


def _read_named(tree: Tree, path: str, walked: set[str]) -> None:
    """A file that the command line names: whatever is odd about it is said."""
    if path in walked:
        return
    walked.add(path)
    tree.remember(path)
    try:
        mode = disk.stat(path).st_mode
        if not stat.S_ISREG(mode):
            raise OSError(f"not a regular file but {describe(mode)}")
    except OSError as error:
        _unreadable(tree, path, error)
        return
    path = path if kind_of_link(path) else disk.realpath(path)
    kind = kind_of(display_name(path), lambda: tree.start(path, HEAD_SIZE))
    source = tree.read(path, kind, judged=True, is_walked=True)
    if source is not None and kind:
        tree.sources.append(source)
    elif source is not None:
        tree.problems.append(Problem("unknown-kind", source.whole))


def kind_of_link(path: str) -> bool:
    """Whether a link is itself the configuration, as the links in ``.wants`` are."""
    return disk.islink(path) and kind_of(display_name(path), lambda: "").startswith("systemd")


def _is_vendor(tree: Tree, file: str, named: str) -> bool:
    """Whether the file is the distribution's own, met on the way through a whole root file system."""
    if tree.root is None or not tree.complete:
        return False
    folders = [os.path.join(tree.root, folder) for folder in VENDOR_FOLDERS]
    return any(file.startswith(folder + "/") and not f"{named}/".startswith(folder + "/") for folder in folders)


def repository_of(path: str) -> str | None:
    """The top of the git repository that a file lies in: the rest of it tells what the file alone cannot."""
    return next((folder for folder in disk.above(path) if disk.lexists(os.path.join(folder, ".git"))), None)


def _read_context(
    tree: Tree, walked: set[str], folders: Iterable[str], excluded: Excluded = lambda path: False
) -> None:
    """Read what is needed to judge the rest, without judging it."""
    for folder in folders:
        ignored: set[str] = set()
        for path in walk(folder, excluded, ignored=ignored):
            _read_walked(tree, path, walked, ignored, judged=False)
