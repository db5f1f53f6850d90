"""Words of a CMakeLists.txt that mean nothing, and that are a letter away from one that does."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterator
from functools import cache
from functools import cached_property
from typing import TYPE_CHECKING

from bringup_lint.facts import rows
from bringup_lint.facts.ros.released import near_current
from bringup_lint.facts.ros.released import released
from bringup_lint.named_tuple import NamedTuple
from bringup_lint.parsers.cmake_commands import Command
from bringup_lint.parsers.cmake_commands import commands
from bringup_lint.parsers.cmake_language import named_for
from bringup_lint.pattern import regex
from bringup_lint.source import Located
from bringup_lint.spelling import Neighbours
from bringup_lint.spelling import numbered

if TYPE_CHECKING:
    from bringup_lint.graph.workspace import Package
    from bringup_lint.graph.workspace import Workspace

_SHORTEST = 5
_CAPITALS = regex(r"[A-Z][A-Z_]{4,40}\Z")
_NAME = regex(r"[A-Za-z][\w.-]*\Z")
_TARGET = regex(r"[\w${}.-]{5,80}\Z")
_VARIABLE = regex(r"\$\{(\w{5,60})\}")
_OF_TARGETS = frozenset(
    "ament_target_dependencies set_target_properties target_compile_definitions target_compile_features"
    " target_compile_options target_include_directories target_link_directories target_link_libraries"
    " target_link_options target_precompile_headers target_sources rclcpp_components_register_node"
    " rclcpp_components_register_nodes".split()
)
"""Commands whose first word is a target."""
_OF_PACKAGES = frozenset(("ament_target_dependencies", "ament_export_dependencies", "rosidl_generate_interfaces"))
_FLOW = frozenset("foreach endforeach function endfunction macro endmacro while endwhile break continue".split())
_ALIKE = frozenset(("add_rostest", "ament_add_test", "nav2_add_test", "rosidl_write_generator_arguments"))
"""Commands that packages of ROS have, and that are called nearly as others."""
_MAKERS = frozenset(("function", "macro"))
_BUILT_IN = frozenset(
    "PROJECT_NAME PROJECT_VERSION PROJECT_SOURCE_DIR PROJECT_BINARY_DIR CMAKE_SOURCE_DIR CMAKE_BINARY_DIR"
    " CMAKE_PROJECT_NAME CMAKE_CURRENT_SOURCE_DIR CMAKE_CURRENT_BINARY_DIR CMAKE_CURRENT_LIST_DIR CMAKE_INSTALL_PREFIX"
    " CMAKE_INSTALL_LIBDIR CMAKE_INSTALL_BINDIR CMAKE_INSTALL_INCLUDEDIR CMAKE_CXX_COMPILER_ID CMAKE_CXX_STANDARD"
    " CMAKE_C_STANDARD CMAKE_CXX_FLAGS CMAKE_BUILD_TYPE CMAKE_COMPILER_IS_GNUCXX CMAKE_MODULE_PATH CMAKE_PREFIX_PATH"
    " CMAKE_SYSTEM_PROCESSOR BUILD_TESTING CATKIN_PACKAGE_SHARE_DESTINATION CATKIN_PACKAGE_BIN_DESTINATION".split()
)
"""Variables that others than the file set."""


class MisspeltBuild(NamedTuple):
    """``kind``: a ``command``, a ``word`` of one, a ``target``, a ``package``, a ``variable``, a ``folder``, or the
    ``project`` that is another one than the package."""

    kind: str
    where: Located
    meant: str
    package: Package
    place: Located | None = None
    """Where what is meant is made, found or named."""


@cache
def _words() -> dict[str, frozenset[str]]:
    found = {command: frozenset(words.split()) for command, words in rows("ros/cmake_words")[1]}
    return {**found, "install": named_for("install") | {"TARGETS", "FILES", "PROGRAMS", "DIRECTORY", "SCRIPT", "CODE"}}


def misspelt_words(workspace: Workspace, package: Package) -> Iterator[MisspeltBuild]:
    sources = [build.source for build in package.builds if build.source.kind == "cmake"]
    given = [command for source in sources for command in commands(source)]
    seen = _Seen(package, workspace, given)
    for command in given:
        yield from _of_command(seen, command)
    if sources:
        yield from _of_project(package, commands(sources[0]))


class _Seen:
    """What the commands of a package name."""

    def __init__(self, package: Package, workspace: Workspace, given: list[Command]) -> None:
        self.package = package
        self.read = {name for build in package.builds for name in _VARIABLE.findall(build.source.text)}
        self.defined = {str(each.arguments[0]).lower() for each in given if each.name in _MAKERS and each.arguments}
        self.uses = Counter(each.name for each in given)
        self.made: dict[str, Located] = {}
        self.found: dict[str, Located] = {}
        self.set: dict[str, Located] = {}
        for command in given:
            self._read(command)
        self.depends = {str(name): name for _, name in package.manifest.depends}
        self.packages = {*workspace.packages, *workspace.ambiguous, *released(), *self.depends}

    @cached_property
    def slips_of_targets(self) -> Neighbours:
        return Neighbours(self.made)

    @cached_property
    def slips_of_depends(self) -> Neighbours:
        return Neighbours(self.depends)

    @cached_property
    def slips_of_found(self) -> Neighbours:
        return Neighbours(self.found)

    def _read(self, command: Command) -> None:
        words = command.arguments
        if command.name == "find_package" and words:
            self.found.setdefault(str(words[0]), words[0])
        elif command.name == "rclcpp_components_register_node":
            self.made.update((str(word), word) for word in words[1:])
        elif command.name not in (*_OF_TARGETS, "install"):
            self.made.update((str(word), word) for word in (words[:1] if "add_" in command.name else words))
        if command.name not in _OF_TARGETS and command.name not in ("if", "elseif"):
            for word in words:
                if _NAME.match(word):
                    self.set.setdefault(str(word), word)


@cache
def _slips_of_command(command: str) -> Neighbours:
    """The words that a command knows; without a name, the commands."""
    return Neighbours(_words()[command] if command else named_for("command") | _FLOW)


_SLIPS_OF_VARIABLES = Neighbours(_BUILT_IN)
_SLIPS_OF_TESTING = Neighbours(("BUILD_TESTING",))
_SLIPS_OF_FOLDERS = Neighbours(("share", "include"))


def _near(word: Located, *known: Neighbours) -> str | None:
    """The one known word that is a letter away."""
    if len(word) < _SHORTEST or any(word in each.known for each in known):
        return None
    found = dict.fromkeys(near for each in known for near in each.meant(word))
    near = [each for each in found if not numbered(each, word) and each[:1] == word[:1]]
    # What differs by an "s" at the end is often another word.
    return near[0] if len(near) == 1 and f"{near[0]}s" != word and f"{word}s" != near[0] else None


def _of_command(seen: _Seen, command: Command) -> Iterator[MisspeltBuild]:
    package, words = seen.package, command.arguments
    if words and command.name not in seen.defined and seen.uses[command.name] == 1 and _is_unknown(command):
        first = words[0].span
        end = first.source.text.rfind("(", 0, first.start)
        while first.source.text[end - 1] in " \t":
            end -= 1
        name = first.source.located(end - len(command.name), end)
        near = _near(Located(command.name, name.span), _slips_of_command(""))
        if near and name.lower() == command.name:
            yield MisspeltBuild("command", name, near, package)
            return
    known = _words().get(command.name, frozenset())
    unknown = [word for word in words if known and word not in known and _CAPITALS.match(word)]
    for word in unknown:
        near = _near(word, _slips_of_command(command.name)) if word not in seen.read else None
        if near:
            yield MisspeltBuild("word", word, near, package)
    yield from _of_targets(seen, command)
    yield from _of_packages(seen, command)
    yield from _of_folders(seen, command)
    for word in words:
        for match in _VARIABLE.finditer(word):
            name = word.part(*match.span(1))
            near = None if name in seen.set or name in _BUILT_IN else _near(name, _SLIPS_OF_VARIABLES)
            if near:
                yield MisspeltBuild("variable", name, near, package)
    if command.name in ("if", "elseif"):
        for word in words:
            if _CAPITALS.match(word) and word not in seen.set and _near(word, _SLIPS_OF_TESTING):
                yield MisspeltBuild("variable", word, "BUILD_TESTING", package)


def _is_unknown(command: Command) -> bool:
    return command.name not in named_for("command") and command.name not in _ALIKE


def _of_targets(seen: _Seen, command: Command) -> Iterator[MisspeltBuild]:
    words = command.arguments
    used: list[Located] = words[:1] if command.name in _OF_TARGETS else []
    if command.name == "install" and words[:1] == ["TARGETS"]:
        ends = (at for at, word in enumerate(words) if at and word in named_for("install"))
        used = words[1 : next(ends, len(words))]
    for word in used:
        if word not in seen.made and _TARGET.match(word) and not word.isupper():
            near = _near(word, seen.slips_of_targets)
            if near:
                yield MisspeltBuild("target", word, near, seen.package, seen.made[near])


def _of_packages(seen: _Seen, command: Command) -> Iterator[MisspeltBuild]:
    words = command.arguments
    if command.name == "find_package" and words and words[0] not in seen.packages and _NAME.match(words[0]):
        near = _near(words[0], seen.slips_of_depends, near_current())
        if near:
            yield MisspeltBuild("package", words[0], near, seen.package, seen.depends.get(near))
    if command.name not in _OF_PACKAGES:
        return
    behind = words
    if command.name == "rosidl_generate_interfaces":
        at = next((at for at, word in enumerate(words) if word == "DEPENDENCIES"), len(words))
        behind = words[at:]
    for word in behind if command.name != "ament_target_dependencies" else words[1:]:
        if _NAME.match(word) and word not in seen.found and word not in seen.packages and not word.isupper():
            near = _near(word, seen.slips_of_found, seen.slips_of_depends)
            if near:
                place = seen.found.get(near) or seen.depends.get(near)
                yield MisspeltBuild("package", word, near, seen.package, place)


def _of_folders(seen: _Seen, command: Command) -> Iterator[MisspeltBuild]:
    if command.name != "install":
        return
    for before, word in zip(command.arguments, command.arguments[1:]):
        first = word.part(0, len(word.partition("/")[0]))
        near = _near(first, _SLIPS_OF_FOLDERS) if before == "DESTINATION" and "/" in word else None
        if near:
            yield MisspeltBuild("folder", first, near, seen.package)


def _of_project(package: Package, given: list[Command]) -> Iterator[MisspeltBuild]:
    """ament_package() ends when the project is not called like the package."""
    if not any(each.name in ("ament_package", "ament_auto_package") for each in given):
        return
    projects = [each for each in given if each.name == "project"]
    first = projects[0].arguments[0] if len(projects) == 1 and projects[0].arguments else None
    if first is not None and not projects[0].conditional and _NAME.match(first) and first != package.name:
        yield MisspeltBuild("project", first, package.name, package, package.manifest.name)
