"""The packages of a workspace in source, and where their installed files come from."""

from __future__ import annotations

import os
import posixpath
import re
from collections.abc import Callable
from collections.abc import Iterable
from collections.abc import Iterator
from fnmatch import fnmatchcase
from functools import cached_property
from typing import TYPE_CHECKING

from bringup_lint.dataclass import dataclass
from bringup_lint.dataclass import field
from bringup_lint.graph.absence import Absence
from bringup_lint.graph.copies import Copies
from bringup_lint.graph.memo import memo
from bringup_lint.model.launch_values import Concat
from bringup_lint.model.launch_values import FileDir
from bringup_lint.model.launch_values import Literal
from bringup_lint.model.launch_values import PackagePrefix
from bringup_lint.model.launch_values import PackageShare
from bringup_lint.model.launch_values import PathJoin
from bringup_lint.model.launch_values import Value
from bringup_lint.model.package import Build
from bringup_lint.model.package import Install
from bringup_lint.model.package import Manifest
from bringup_lint.named_tuple import NamedTuple
from bringup_lint.pattern import regex
from bringup_lint.source import Located
from bringup_lint.source import Source

if TYPE_CHECKING:
    from bringup_lint.discover.tree import Tree
    from bringup_lint.graph.files import Files

SUBFOLDERS = 40
"""CMake folders of one package that are followed."""

_CARRIED = regex(r"(?:^|/)(?:third[_-]?party|3rd[_-]?party|vendor(?:ed)?|submodules)/", re.IGNORECASE)
"""Folders of a package that keep sources of others."""
_MAKES = regex(
    r"^[ \t]*(?:configure_file|add_custom_(?:command|target)|execute_process|xacro_add_\w{1,20}"
    r"|file[ \t]*\(\s*"
    r"(?:WRITE|APPEND|TOUCH|GENERATE|CONFIGURE|DOWNLOAD|COPY|COPY_FILE|RENAME|CREATE_LINK|ARCHIVE_EXTRACT))\b"
    r"|BINARY_DIR\b",
    re.M | re.I,
)
"""Commands of CMake that make files, and the folder that these are in."""

_WILDCARD = regex(r"[*?\[]")


def makes_files(build: Source) -> bool:
    """Whether a build description has commands that make files."""
    return _MAKES.search(build.text) is not None


class Place(NamedTuple):
    """A path in terms of what it is relative to: ``share`` or ``prefix`` of a package, ``file`` for an absolute path
    beside a file of the tree, or ``""`` for a path as it is written."""

    base: str
    package: str
    path: str


class Found(NamedTuple):
    """What a path leads to: the file in the source tree, and whether the build installs it (None: not known)."""

    file: str | None
    installed: bool | None
    package: Package | None


class Made(NamedTuple):
    """A program that is built and that ``ros2 run`` does not find."""

    target: Located
    elsewhere: Located | None
    """Where it is installed into another folder."""
    others: Located | None
    """The installation of other programs."""


@dataclass(eq=False)
class Package:
    """One package of the workspace: its manifest, and what its build makes and installs."""

    manifest: Manifest
    folder: str
    """Absolute."""
    builds: list[Build] = field(default_factory=list)
    complete: bool = True
    """Every build description of the package was found and read."""

    @property
    def name(self) -> str:
        return str(self.manifest.name)

    @property
    def place(self) -> Located | Source:
        """Where the package has its name."""
        return self.manifest.name or self.manifest.source

    @property
    def installs_known(self) -> bool:
        return self.complete and all(build.installs_known for build in self.builds)

    @property
    def executables_known(self) -> bool:
        return self.complete and all(build.executables_known for build in self.builds)

    @property
    def plugins_known(self) -> bool:
        return self.complete and all(build.plugins_known for build in self.builds)

    @cached_property
    def executables(self) -> dict[str, Located]:
        return {name: place for build in self.builds for name, place in build.executables.items()}

    @cached_property
    def entry_points(self) -> dict[str, str]:
        """Console script -> ``package.module:function``."""
        return {name: target for build in self.builds for name, target in build.entry_points.items()}

    def is_misplaced(self, executable: str) -> bool:
        """Whether a console script is certainly not installed where ``ros2 run`` looks, in ``lib/<package>``."""
        if executable not in self.entry_points or any(self.origins(f"lib/{self.name}/{executable}")):
            return False
        return self.executables_known and self.installs_known and self._scripts_misplaced

    @property
    def scripts_folder(self) -> Located | None:
        """Where setup.cfg says that console scripts go."""
        return next((build.scripts_folder for build in self.builds if build.scripts_folder), None)

    @cached_property
    def without_mode(self) -> dict[str, Located]:
        """The programs that are only installed as plain files, by the place of the file."""
        programs = {name for build in self.builds for name in build.executables if name not in build.without_mode}
        plain = {name: place for build in self.builds for name, place in build.without_mode.items()}
        return {name: place for name, place in plain.items() if name not in programs}

    def made(self, program: str) -> Made | None:
        """A program that CMake makes, and does not install where ``ros2 run`` looks."""
        for build in self.builds:
            if program in build.built:
                return Made(build.built[program], build.elsewhere.get(program), build.programs_at)
        return None

    @cached_property
    def makes_files(self) -> bool:
        """Whether the build may make files that are not in the tree."""
        return any(makes_files(build.source) for build in self.builds)

    @cached_property
    def _scripts_misplaced(self) -> bool:
        if not all(build.scripts_folder_known for build in self.builds):
            return False
        folders = [build.scripts_folder.rstrip("/") for build in self.builds if build.scripts_folder]
        computed = any("$" in folder.removeprefix("$base/") for folder in folders)
        return not computed and not any(folder.endswith(f"lib/{self.name}") for folder in folders)

    @cached_property
    def plugins(self) -> list[Located]:
        return [plugin for build in self.builds for plugin in build.plugins]

    def depends_on(self, package: str) -> bool:
        return any(name == package for _, name in self.manifest.depends)

    def origins(self, path: str) -> Iterator[str]:
        """The source files, there or not, that the build would install at a path below the prefix."""
        for folder, install, destination, source in self._installs:
            origin = _origin(install, destination, source, path)
            if origin is not None:
                yield os.path.normpath(os.path.join(folder, origin))

    @cached_property
    def _installs(self) -> list[tuple[str, Install, str, str]]:
        """Each installation with the folder of its build description, its destination and its source in plain form."""
        return [
            (
                os.path.dirname(build.source.absolute),
                install,
                posixpath.normpath(install.destination),
                posixpath.normpath(install.source),
            )
            for build in self.builds
            for install in build.installs
        ]

    def taking_others(self, path: str) -> Install | None:
        """What installs other files of the folder of a file, by an absolute path."""
        for build in self.builds:
            folder = os.path.dirname(build.source.absolute)
            for install in build.installs:
                source = os.path.normpath(os.path.join(folder, install.source))
                if not install.tree and os.path.dirname(source) == os.path.dirname(path):
                    return install
        return None

    def takes(self, path: str) -> bool:
        """Whether the build installs a source file, whatever becomes its name and place."""
        for build in self.builds:
            folder = os.path.dirname(build.source.absolute)
            for install in build.installs:
                source = os.path.normpath(os.path.join(folder, install.source))
                if fnmatchcase(path, source) or (install.tree and path.startswith(f"{source}/")):
                    return True
        return False


def _globbed(path: str, named: Callable[[str], Iterable[str]]) -> Iterator[str]:
    """A path whose folders may hold wildcards: a glob over folders puts all files into one."""
    folder, name = os.path.split(path)
    if not _WILDCARD.search(folder):
        yield path
        return
    fixed = _WILDCARD.split(folder)[0].rpartition("/")[0]
    pattern = folder[len(fixed) :].strip("/").split("/")
    for found in named(name):
        if found.startswith(fixed + "/") and _reaches(pattern, os.path.dirname(found)[len(fixed) :].split("/")[1:]):
            yield found


def _reaches(pattern: list[str], folders: list[str]) -> bool:
    """Whether a glob means a folder: ``**`` is any number of folders, also none."""
    reachable = {0}
    for part in pattern:
        if part == "**":
            reachable = set(range(min(reachable, default=len(folders)), len(folders) + 1))
        else:
            reachable = {at + 1 for at in reachable if at < len(folders) and fnmatchcase(folders[at], part)}
    return len(folders) in reachable


def _origin(install: Install, destination: str, source: str, path: str) -> str | None:
    if not install.tree:
        folder, name = posixpath.split(path)
        if install.renamed:
            return source if posixpath.join(destination, install.renamed) == path else None
        if posixpath.normpath(folder) == destination and fnmatchcase(name, posixpath.basename(source)):
            return posixpath.join(posixpath.dirname(source), name)
        return None
    if not install.source.endswith("/"):
        destination = posixpath.join(destination, posixpath.basename(source))
    if path == destination or path.startswith(destination + "/"):
        return posixpath.join(source, path[len(destination) + 1 :])
    return None


class Workspace:
    """Asked as ``launch.workspace``: the packages by name, the owner of a file, the source of an installed one."""

    def __init__(self, tree: Tree, packages: dict[str, Package], ambiguous: set[str], copies: Copies) -> None:
        self.tree = tree
        self._copies = copies
        self.packages = packages
        self.ambiguous = ambiguous
        """Names that several packages of the tree have."""

    @cached_property
    def _folders(self) -> dict[str, Package]:
        return {package.folder: package for package in self.packages.values()}

    def is_vendored(self, source: Source) -> bool:
        """Whether others wrote a file that the tree only carries: it lies in a folder for what others wrote, or its
        package is one of a minority with a change log as releases have it."""
        owner = self.owner(source)
        if owner is None:
            return _CARRIED.search(source.name) is not None
        if self._copies.is_kept_apart(owner.folder):
            return True
        return _CARRIED.search(os.path.relpath(source.absolute, owner.folder)) is not None

    def required(self, package: Package) -> Iterator[str]:
        """What a package depends on, directly or through other packages of the workspace."""
        todo, seen = [package], {package.name}
        while todo:
            for _, name in todo.pop().manifest.depends:
                yield name
                if name in self.packages and name not in seen:
                    seen.add(str(name))
                    todo.append(self.packages[str(name)])

    @memo
    def owner(self, source: Source) -> Package | None:
        """The package that a file lies in."""
        return self.package_of(os.path.dirname(source.absolute))

    @memo
    def package_of(self, folder: str) -> Package | None:
        """The package that an absolute folder is, or lies in."""
        while folder not in self._folders:
            above = os.path.dirname(folder)
            if above == folder:
                return None
            folder = above
        return self._folders[folder]

    def find(self, place: Place | None) -> Found | None:
        """The source of a file; None when the tree cannot tell."""
        return None if place is None else self._found(place)

    def leaves_out(self, source: Source) -> bool:
        """Whether a file lies in a package whose build surely does not install it."""
        owner = self.owner(source)
        if owner is None or not owner.installs_known:
            return False
        found = self._share(owner, os.path.relpath(source.absolute, owner.folder))
        return found is not None and found.installed is False

    @memo
    def _found(self, place: Place) -> Found | None:
        if place.base == "file":
            return self._beside(os.path.normpath(place.path))
        package = self.packages.get(place.package)
        if package is None or place.base != "share":
            return None
        return self._share(package, posixpath.normpath(place.path))

    def _beside(self, path: str) -> Found | None:
        if self.tree.exists(path):
            return Found(path, None, None)
        for folder, package in self._folders.items():
            if path.startswith(folder + "/"):
                return self._share(package, os.path.relpath(path, folder))
        return None

    def _share(self, package: Package, path: str) -> Found | None:
        if path.startswith("../"):
            return None
        target = posixpath.normpath(f"share/{package.name}/{path}")
        origins = (each for origin in package.origins(target) for each in _globbed(origin, self.tree.named))
        for origin in origins:
            if self.tree.exists(origin):
                return Found(origin, True, package)
        direct = os.path.join(package.folder, path)
        there = self.tree.exists(direct)
        if there:
            return Found(direct, False if package.installs_known else None, package)
        if any(map(self.tree.exists, _templates(direct))):
            return None
        absent = package.installs_known or self._absence(package).of_file(path)
        return Found(None, False, package) if absent and not self._has_copy(package, path) else None

    def _has_copy(self, package: Package, path: str) -> bool:
        """Whether another folder of the package's name has the file: the tree keeps versions of the package, and one
        without a manifest may be meant."""
        tail = f"/{package.name}/{path}"
        own = package.folder + "/"
        named = self.tree.named(posixpath.basename(path))
        return any(found.endswith(tail) and not found.startswith(own) for found in named)

    def lacks(self, package: Package, executable: str) -> bool:
        """Whether ``ros2 run`` certainly does not find an executable of a package."""
        if executable in package.executables:
            return False
        if any(self.tree.exists(origin) for origin in package.origins(f"lib/{package.name}/{executable}")):
            return False
        return package.executables_known or self._absence(package).of_executable(executable)

    def lacks_file(self, package: Package, name: str) -> bool:
        """Whether a package surely installs no file of a name: what it installs is known, or nothing is called so."""
        return package.installs_known or self._absence(package).of_file(name)

    @memo
    def _absence(self, package: Package) -> Absence:
        return Absence(self.tree, package.folder, package.builds)


def _templates(path: str) -> Iterator[str]:
    """Files that a build may make a file from."""
    for suffix in (".in", ".em", ".j2", ".template", ".xacro"):
        yield path + suffix
    if path.endswith((".urdf", ".sdf", ".srdf")):
        yield path.rpartition(".")[0] + ".xacro"


def place(value: Value) -> Place | None:
    """A resolved value as a path; None when part of it is not known."""
    if isinstance(value, Literal) and isinstance(value.value, str):
        return Place("", "", str(value.value))
    if isinstance(value, FileDir):
        path = value.span.source.absolute
        return Place("file", "", path if value.itself else os.path.dirname(path))
    if isinstance(value, (PackageShare, PackagePrefix)):
        name = value.package
        if isinstance(name, Literal) and isinstance(name.value, str):
            return Place("share" if isinstance(value, PackageShare) else "prefix", str(name.value), "")
        return None
    if isinstance(value, (PathJoin, Concat)):
        return _compound(value)
    return None


def _compound(value: PathJoin | Concat) -> Place | None:
    first = place(value.parts[0])
    texts = [part.value for part in value.parts[1:] if isinstance(part, Literal) and isinstance(part.value, str)]
    if first is None or len(texts) < len(value.parts) - 1:
        return None
    if isinstance(value, PathJoin):
        return Place(first.base, first.package, posixpath.join(first.path, *texts))
    path = first.path + "".join(texts)
    return Place(first.base, first.package, path.lstrip("/") if first.base in ("share", "prefix") else path)


def load_workspace(files: Files) -> Workspace:
    from bringup_lint.parsers import package_xml

    packages: dict[str, Package] = {}
    ambiguous: set[str] = set()
    builds = {source.absolute: source for source in files.of_kind("cmake", "setup-py", "setup-cfg")}
    for manifest in files.parsed(package_xml.parse, files.of_kind("ros-package")):
        if not manifest.name:
            continue
        name = str(manifest.name)
        if name in packages or name in ambiguous:
            ambiguous.add(name)
            packages.pop(name, None)
            continue
        package = Package(manifest, os.path.dirname(manifest.source.absolute))
        _read_builds(files, package, builds)
        packages[name] = package
    return Workspace(files.tree, packages, ambiguous, Copies(files))


def _read_builds(files: Files, package: Package, sources: dict[str, Source]) -> None:
    python = sources.get(os.path.join(package.folder, "setup.py"))
    settings = sources.get(os.path.join(package.folder, "setup.cfg"))
    lists = os.path.join(package.folder, "CMakeLists.txt")
    if package.manifest.build_type == "ament_python":
        package.builds += _of_setup(files, python, settings)
        if files.tree.exists(os.path.join(package.folder, "pyproject.toml")):
            package.complete = False
    else:
        _read_cmake(files, package, lists, sources)
        if any(build.installs_python for build in package.builds):
            package.builds += _of_setup(files, None, settings)
    package.complete = bool(package.builds) and package.complete


def _of_setup(files: Files, python: Source | None, settings: Source | None) -> Iterator[Build]:
    if python is None and settings is None:
        return
    from bringup_lint.parsers import setup_py

    yield from files.parsed(setup_py.parse, [python] if python else [])
    yield from files.parsed(setup_py.parse_cfg, [settings] if settings else [])


def _read_cmake(files: Files, package: Package, path: str, sources: dict[str, Source]) -> None:
    source = sources.get(path)
    if source is None or len(package.builds) >= SUBFOLDERS:
        package.complete = False
        return
    from bringup_lint.parsers import cmake
    from bringup_lint.parsers.cmake_language import Around

    folder = os.path.dirname(source.absolute)

    def below(inner: str) -> Iterator[str]:
        top = os.path.normpath(os.path.join(folder, inner))
        return (os.path.relpath(path, folder) for path in files.tree.walked_below(top))

    around = Around(lambda path: files.tree.beside(source, path), below)
    for build in files.parsed(lambda one: cmake.parse(one, package.name, around), [source]):
        package.builds.append(build)
        for folder in build.subdirectories:
            inner = os.path.normpath(os.path.join(os.path.dirname(path), folder, "CMakeLists.txt"))
            if inner != path:
                _read_cmake(files, package, inner, sources)
