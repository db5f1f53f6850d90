"""Messages, services and actions of the packages of a workspace: what they define, generate, and are asked for."""

from __future__ import annotations

import ast
import os
import re
from collections.abc import Callable
from collections.abc import Iterator
from functools import cached_property
from typing import TYPE_CHECKING

from bringup_lint.graph.interface_files import KINDS
from bringup_lint.graph.interface_files import NAMED
from bringup_lint.graph.interface_files import interface_files
from bringup_lint.named_tuple import NamedTuple
from bringup_lint.parsers.cmake_commands import Command
from bringup_lint.parsers.cmake_commands import commands
from bringup_lint.parsers.python_syntax import Positions
from bringup_lint.parsers.python_syntax import byte_order_mark
from bringup_lint.parsers.python_syntax import tree_of
from bringup_lint.pattern import regex
from bringup_lint.source import Located
from bringup_lint.source import Source
from bringup_lint.source import Span

if TYPE_CHECKING:
    from bringup_lint.discover.tree import Tree
    from bringup_lint.graph.files import Files
    from bringup_lint.graph.workspace import Package
    from bringup_lint.graph.workspace import Workspace

_WORD_START = regex(r"(?<=[a-z0-9])(?=[A-Z])|(?<=[A-Z])(?=[A-Z][a-z])")
GENERATE = "rosidl_generate_interfaces"
_GROUP = "rosidl_interface_packages"
_IMPLICIT = frozenset(("builtin_interfaces", "action_msgs", "service_msgs", "unique_identifier_msgs"))
"""Packages that the command adds by itself, in some distributions."""
_BRINGS = {
    **{"builtin_interfaces": "", "unique_identifier_msgs": "", "std_srvs": "", "std_msgs": "builtin_interfaces"},
    **{"geometry_msgs": "std_msgs", "sensor_msgs": "geometry_msgs", "nav_msgs": "geometry_msgs"},
    **{"shape_msgs": "geometry_msgs", "diagnostic_msgs": "geometry_msgs", "trajectory_msgs": "geometry_msgs"},
    **{"stereo_msgs": "sensor_msgs", "visualization_msgs": "geometry_msgs sensor_msgs", "service_msgs": ""},
    **{"action_msgs": "unique_identifier_msgs service_msgs", "geographic_msgs": "geometry_msgs unique_identifier_msgs"},
}
"""Packages of interfaces -> what they depend on themselves, at most. Source: their package.xml, Humble to Kilted."""
_OF_INTERFACES = ("_msgs", "_interfaces", "_srvs")
_FIELD = regex(
    r"(?m)^[ \t]*(?:(?P<package>[a-z][a-z0-9_]*)/(?:msg/)?)?(?P<name>[A-Z]\w*)(?:\[[^\]\n]*\])?"
    r"[ \t]+[a-z]\w*[ \t]*(?:#|$)"
)
"""A field with the type of a message, of the same package where none is named."""


class MissingInterface(NamedTuple):
    """An import of a message, service or action that the package of the tree does not have."""

    name: Located
    kind: str
    owner: Package
    known: tuple[str, ...]
    """Those of the same kind that the package defines."""
    file: str | None
    """The definition, where one lies in the tree without being generated."""


class Ungenerated(NamedTuple):
    """A package that does not generate what it defines, or that CMake refuses."""

    kind: str
    """``none`` of the definitions is generated, ``group`` of the manifest is missing, a ``dependency``, a ``file``
    that is listed, or a definition is ``unlisted`` whose header a node includes, or a ``field`` of one that is
    listed has the type of one that is not."""
    package: Package
    where: Span
    names: tuple[str, ...]
    """The definitions, the packages whose types they use, or the files."""
    used: Span | None = None
    """Where a node includes the first of the definitions, or another has it as a field."""


class PackageInterfaces:
    """The definitions of one package, by kind and name, each with its path, and what generates them."""

    def __init__(self, tree: Tree, package: Package) -> None:
        self._tree = tree
        self.package = package

    @cached_property
    def defined(self) -> dict[tuple[str, str], str]:
        return interface_files(self._tree, self.package.folder)

    @cached_property
    def commands(self) -> list[Command]:
        """Of the CMakeLists.txt of the package; empty when it has none."""
        source = next((each.source for each in self.package.builds if each.source.kind == "cmake"), None)
        return commands(source) if source is not None else []

    @cached_property
    def generators(self) -> list[Command]:
        return [each for each in self.commands if each.name == GENERATE]

    @cached_property
    def words(self) -> list[Located] | None:
        """What the command is given, with the values of variables; None when one of these is not known."""
        builds = (each for each in self.package.builds if each.source.kind == "cmake")
        build = next(builds, None)
        return build.interfaces if build is not None else None

    @cached_property
    def dependencies(self) -> frozenset[str] | None:
        """The packages that the command lists as dependencies; None when these are not known."""
        if self.words is None:
            return None
        words = [str(each) for each in self.words]
        behind = words[words.index("DEPENDENCIES") + 1 :] if "DEPENDENCIES" in words else []
        return frozenset(word for word in behind if not word.isupper())

    @cached_property
    def is_closed(self) -> bool:
        """Whether nothing but the one command of the CMakeLists.txt can generate an interface."""
        others = [each.name for each in self.commands if "idl" in each.name and each.name != GENERATE]
        made = [each for each in self.commands if each.name in ("configure_file", "include", "execute_process")]
        # A package without definitions lies in a submodule that is not there, or generates them.
        return len(self.generators) == 1 and not others and not made and bool(self.defined)

    @cached_property
    def listed(self) -> frozenset[str] | None:
        """The names of the files that the command lists; None when they are computed."""
        words = self.words
        if not words:
            return None
        return frozenset(os.path.basename(word).partition(".")[0] for word in words if "." in word)

    def lacks(self, kind: str, name: str) -> bool:
        listed = self.listed
        return (kind, name) not in self.defined or (listed is not None and name not in listed)


Imports = tuple[tuple[str, str, Located], ...]
"""Package, kind and name of each interface that a source imports."""


def missing_interfaces(
    files: Files, workspace: Workspace, interfaces_of: Callable[[Package], PackageInterfaces]
) -> Iterator[MissingInterface]:
    """The imports of nodes that raise an exception because the interface does not exist."""
    sources = (each for each in files.of_kind("python-node") if each.judged)
    for source in sources:
        imported = _imports(source)
        for package, kind, name in imported:
            owner = workspace.packages.get(package)
            if owner is None or owner.manifest.is_ros1:
                continue
            interfaces = interfaces_of(owner)
            if not _is_required(workspace, source, package) and not _is_used(interfaces, imported):
                continue
            if interfaces.is_closed and interfaces.lacks(kind, str(name).partition("_")[0]):
                names = tuple(sorted(each for of, each in interfaces.defined if of == kind))
                yield MissingInterface(name, kind, owner, names, interfaces.defined.get((kind, str(name))))


def _is_required(workspace: Workspace, source: Source, package: str) -> bool:
    """Whether the package of a source declares another one: else it may mean one of the same name from elsewhere."""
    importer = workspace.owner(source)
    return importer is not None and (importer.name == package or package in workspace.required(importer))


def _is_used(interfaces: PackageInterfaces, imported: Imports) -> bool:
    """Whether a source that imports all this also imports what the package has, so that it means this one."""
    found = ((kind, str(name)) for package, kind, name in imported if package == interfaces.package.name)
    return any(each in interfaces.defined for each in found)


def _imports(source: Source) -> Imports:
    """The same as ``_imported``, made once for each source."""
    return source.once(_imports, lambda: tuple(_imported(source)))


def _imported(source: Source) -> Iterator[tuple[str, str, Located]]:
    """Package, kind and name of the interfaces that a module imports without a way round it, no modules of theirs."""
    if not any(f".{kind}" in source.text for kind in KINDS):
        return
    tree = tree_of(source)
    if tree is None:
        return
    positions = Positions(source, byte_order_mark(source))
    for statement in tree.body:
        if isinstance(statement, ast.ImportFrom) and not statement.level:
            package, _, kind = (statement.module or "").partition(".")
            if kind in KINDS:
                yield from (
                    (package, kind, _name(positions, alias)) for alias in statement.names if alias.name[0].isupper()
                )


def _name(positions: Positions, alias: ast.alias) -> Located:
    start = positions.offset(alias.lineno, alias.col_offset)
    return Located(alias.name, positions.source.span(start, start + len(alias.name)))


def is_judged(package: Package, interfaces: PackageInterfaces) -> bool:
    """Whether CMake generates the definitions of a package."""
    return package.manifest.build_type == "ament_cmake" and package.complete and bool(interfaces.defined)


def ungenerated(
    files: Files, workspace: Workspace, interfaces_of: Callable[[Package], PackageInterfaces]
) -> Iterator[Ungenerated]:
    """The packages of the tree's authors whose definitions are not generated, or make the build fail."""
    for package in workspace.packages.values():
        interfaces = interfaces_of(package)
        if is_judged(package, interfaces):
            yield from _of_package(files, workspace, package, interfaces)


def _of_package(
    files: Files, workspace: Workspace, package: Package, interfaces: PackageInterfaces
) -> Iterator[Ungenerated]:
    if not interfaces.generators:
        own = tuple(sorted(name for (kind, name), path in interfaces.defined.items() if is_place(package, kind, path)))
        is_meant = "rosidl" in package.manifest.source.text or any(_speaks(each) for each in interfaces.commands)
        place = _place(interfaces)
        is_made = any("idl" in each.name or each.name == "include" for each in interfaces.commands)
        if own and is_meant and place is not None and not is_made:
            yield Ungenerated("none", package, place, own)
        return
    command = interfaces.generators[0]
    if command.conditional or len(interfaces.generators) > 1 or not command.arguments:
        return
    words = interfaces.words or command.arguments[1:]
    absent = sorted(str(word) for word in words if _is_absent(files.tree, package, word))
    if absent:
        yield Ungenerated("file", package, command.arguments[0].span, tuple(absent))
    skips = any(str(word).startswith("SKIP_") for word in words)
    if not skips and _GROUP not in package.manifest.source.text and package.manifest.name is not None:
        last = next(reversed(package.manifest.places.values()), package.manifest.name.span)
        yield Ungenerated("group", package, last, ())
    unlisted = dict(sorted(_unlisted(files, package, interfaces)))
    if unlisted:
        place = next(iter(unlisted.values()))
        yield Ungenerated("unlisted", package, command.arguments[0].span, tuple(unlisted), place)
    fields = {name: span for name, span in _unlisted_fields(files, package, interfaces) if name not in unlisted}
    if fields:
        yield Ungenerated("field", package, command.arguments[0].span, tuple(fields), next(iter(fields.values())))
    brought = _brought(workspace, interfaces)
    if brought is not None:
        used = sorted(_used(files, package, interfaces) - _IMPLICIT - brought)
        if used:
            yield Ungenerated("dependency", package, command.arguments[0].span, tuple(used))


def _brought(workspace: Workspace, interfaces: PackageInterfaces) -> set[str] | None:
    """The dependencies of the command with what these depend on, which is found through them; None when that is not
    known."""
    todo = interfaces.dependencies
    if todo is None:
        return None
    found: set[str] = set()
    while todo - found:
        name = min(todo - found)
        found.add(name)
        if name in workspace.packages:
            required = {str(each) for each in workspace.required(workspace.packages[name])}
            todo |= {each for each in required if each in _BRINGS or each.endswith(_OF_INTERFACES)}
            found |= required - todo
        elif name not in _BRINGS:
            return None
        else:
            todo |= set(_BRINGS[name].split())
    return found


def _is_absent(tree: Tree, package: Package, word: str) -> bool:
    """Whether a listed file is not in the tree, and nothing makes it."""
    if "$" in word or NAMED.search(word) is None:
        return False
    path = os.path.normpath(os.path.join(package.folder, word))
    return not tree.exists(path) and not tree.is_ignored(path)


def _unlisted(files: Files, package: Package, interfaces: PackageInterfaces) -> Iterator[tuple[str, Span]]:
    """The definitions that the command does not list, each with the first place where a node in C++ uses its code."""
    if not interfaces.is_closed or interfaces.listed is None:
        return
    for (kind, name), path in interfaces.defined.items():
        if name in interfaces.listed or not is_place(package, kind, path) or files.tree.is_ignored(path):
            continue
        if not _is_written(files.tree, package, kind, name):
            used = _in_cpp(package.name, kind, name)
            texts = (each for each in files.sources if each.judged and package.name in each.text)
            found = ((each, match) for each in texts if (match := used.search(each.said)))
            for source, match in found:
                yield f"{kind}/{os.path.basename(path)}", source.span(*match.span())
                break


def _unlisted_fields(files: Files, package: Package, interfaces: PackageInterfaces) -> Iterator[tuple[str, Span]]:
    """The messages that the command does not list, each with a field of this type in a definition that it lists."""
    listed = interfaces.listed
    if not interfaces.is_closed or listed is None:
        return
    messages = {name: path for (kind, name), path in interfaces.defined.items() if kind == "msg"}
    lost = {name for name, path in messages.items() if name not in listed and is_place(package, "msg", path)}
    if not lost:
        return
    for source, match in _fields(files, package, interfaces):
        if match["name"] in lost and match["package"] in (None, package.name):
            yield f"msg/{os.path.basename(messages[match['name']])}", source.span(*match.span("name"))


def _is_written(tree: Tree, package: Package, kind: str, name: str) -> bool:
    """Whether the package has a header of its own where that of an interface would be."""
    header = os.path.join(package.folder, "include", package.name, kind, _header(name))
    return any(tree.exists(f"{header}{suffix}") for suffix in (".h", ".hpp"))


def _header(name: str) -> str:
    return _WORD_START.sub("_", name).lower()


def _in_cpp(package: str, kind: str, name: str) -> re.Pattern[str]:
    """The header of an interface, or its class."""
    header = re.escape(f"{package}/{kind}/{_header(name)}.h")
    type_name = re.escape(f"{package}::{kind}::{name}")
    return re.compile(rf"\b{header}|\b{type_name}\b")


def is_place(package: Package, kind: str, path: str) -> bool:
    """Whether a definition lies where those of a package do."""
    return os.path.dirname(path) == os.path.join(package.folder, kind)


def _place(interfaces: PackageInterfaces) -> Span | None:
    """Where the CMakeLists.txt speaks of interfaces, else its first argument."""
    given = [each for each in interfaces.commands if each.arguments]
    return next((each for each in given if _speaks(each)), given[0]).arguments[0].span if given else None


def _speaks(command: Command) -> bool:
    """Whether a command has to do with the generation of interfaces."""
    return any("rosidl" in argument or argument.endswith(".msg") for argument in command.arguments)


def _used(files: Files, package: Package, interfaces: PackageInterfaces) -> set[str]:
    """The other packages whose types the listed definitions have fields of."""
    fields = _fields(files, package, interfaces)
    return {match["package"] for _, match in fields if match["package"] is not None} - {package.name}


def _fields(files: Files, package: Package, interfaces: PackageInterfaces) -> Iterator[tuple[Source, re.Match[str]]]:
    """The fields of the listed definitions that have the type of a message."""
    listed = interfaces.listed
    for (kind, name), path in interfaces.defined.items():
        source = files.tree.read(path, judged=False) if kind in KINDS and not path.endswith(".idl") else None
        if source is not None and is_place(package, kind, path) and (listed is None or name in listed):
            yield from ((source, match) for match in _FIELD.finditer(source.text))
