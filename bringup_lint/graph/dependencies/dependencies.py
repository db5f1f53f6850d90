"""What the packages of a workspace need and no package.xml declares, and whether anything of the tree brings it."""

from __future__ import annotations

import os
import re
import sys
from collections.abc import Callable
from collections.abc import Iterator
from functools import cached_property
from typing import TYPE_CHECKING

from bringup_lint.facts.ros.needed import base
from bringup_lint.facts.ros.needed import instead_of
from bringup_lint.facts.ros.needed import not_rosdep
from bringup_lint.facts.ros.needed import of_key
from bringup_lint.facts.ros.needed import unresolved
from bringup_lint.facts.ros.released import released
from bringup_lint.graph.dependencies.build_needs import of_builds
from bringup_lint.graph.dependencies.build_needs import of_headers
from bringup_lint.graph.dependencies.build_needs import of_interfaces
from bringup_lint.graph.dependencies.built_alone import Apart
from bringup_lint.graph.dependencies.idle_globs import IdleGlob
from bringup_lint.graph.dependencies.idle_globs import idle_globs
from bringup_lint.graph.dependencies.installers import ROSDEP
from bringup_lint.graph.dependencies.installers import Installers
from bringup_lint.graph.dependencies.interfaces import MissingInterface
from bringup_lint.graph.dependencies.interfaces import PackageInterfaces
from bringup_lint.graph.dependencies.interfaces import Ungenerated
from bringup_lint.graph.dependencies.interfaces import missing_interfaces
from bringup_lint.graph.dependencies.interfaces import ungenerated
from bringup_lint.graph.dependencies.missing_files import missing_files
from bringup_lint.graph.dependencies.misspelt_packages import MisspeltPackage
from bringup_lint.graph.dependencies.misspelt_packages import misspelt_packages
from bringup_lint.graph.dependencies.modules_beside import LeftBeside
from bringup_lint.graph.dependencies.modules_beside import left_beside
from bringup_lint.graph.dependencies.needs import Need
from bringup_lint.graph.dependencies.needs import of_descriptions
from bringup_lint.graph.dependencies.needs import of_launch
from bringup_lint.graph.dependencies.needs import of_launch_files
from bringup_lint.graph.dependencies.needs import of_nodes
from bringup_lint.graph.dependencies.plain_programs import plain_programs
from bringup_lint.graph.dependencies.plain_programs import programs_without_mode
from bringup_lint.graph.dependencies.plain_programs import unplaced_programs
from bringup_lint.graph.dependencies.plugin_needs import of_plugins
from bringup_lint.graph.dependencies.provided import Provided
from bringup_lint.graph.dependencies.ros1_programs import ros1_programs
from bringup_lint.graph.dependencies.subpackages import LeftOut
from bringup_lint.graph.dependencies.subpackages import left_out
from bringup_lint.graph.dependencies.unexported import Unexported
from bringup_lint.graph.dependencies.unexported import unexported
from bringup_lint.graph.dependencies.unloadable import Unloadable
from bringup_lint.graph.dependencies.unloadable import unloadable
from bringup_lint.graph.dependencies.unregistered import Unregistered
from bringup_lint.graph.dependencies.unregistered import unregistered
from bringup_lint.graph.launch.packages import is_known_package
from bringup_lint.graph.launch.started import literal_text
from bringup_lint.graph.memo import memo
from bringup_lint.graph.purpose import Purpose
from bringup_lint.pattern import regex

if TYPE_CHECKING:
    from bringup_lint.graph.dependencies.data_beside import Beside
    from bringup_lint.graph.dependencies.interface_lines import RefusedDefinition
    from bringup_lint.graph.dependencies.misspelt_builds import MisspeltBuild
    from bringup_lint.graph.dependencies.misspelt_depends import MisspeltDependency
    from bringup_lint.graph.dependencies.setup_settings import UnreadSetting
    from bringup_lint.graph.files import Files
    from bringup_lint.graph.launch.launch import Launch
    from bringup_lint.graph.workspace import Package
    from bringup_lint.model.dockerfile import Dockerfile
    from bringup_lint.model.package import Install
    from bringup_lint.model.package import Manifest
    from bringup_lint.source import Located
    from bringup_lint.source import Span

_GOES_ON = regex(r"\s-[a-qs-z]*r[a-z]*(?:\s|$)|\s-s\s|--simulate|--dependency-types|\s-t\s|\|\|")
"""rosdep installs the rest, only says what it would do, or its failure is ignored."""
_FOREIGN = regex(r"(?:^|_)(?:vendor|stubs?|template)(?:_|$)|[{}$<]")
"""Names of packages that wrap the build of others, and of templates."""
_INSTALLS = regex(
    r"\b(?:apt|apt-get|aptitude|pip3?)\b[^\n]{0,200}?\binstall\b|^[ \t-]{0,40}(?:ansible\.builtin\.)?(?:apt|pip):",
    re.M,
    hints="apt pip",
)
"""A step that installs packages."""
_SELECTS = "--packages-select "
_BUILDS = regex(
    r"^(?![^\n]{0,500}\b(?:alias|echo|printf)\b)[^\n]{0,500}?\bcolcon\s+build\b(?:\\\r?\n|[^\n;&|]){0,2000}",
    re.M,
    "colcon",
)
"""A command that is run, and not shown or kept for later."""
_OF_FOCAL = ("foxy", "galactic")
"""The distributions of ROS for Ubuntu 20.04."""
_COMMON = frozenset(
    "numpy yaml pytest setuptools pkg_resources packaging psutil requests em lark lxml cryptography netifaces click gi"
    " apt dbus systemd".split()
)
"""Modules that come with ros-base or Ubuntu."""


_NEEDS = (
    of_builds,
    of_interfaces,
    of_launch,
    of_launch_files,
    of_descriptions,
    of_plugins,
    of_nodes,
    of_headers,
)


class Dependencies:
    """Asked as ``robot.dependencies``: what packages need, and whether anything of the tree brings it."""

    def __init__(self, files: Files, launch: Launch, dockerfiles: Callable[[], list[Dockerfile]]) -> None:
        self._files = files
        self._launch = launch
        self._dockerfiles = dockerfiles

    def undeclared(self, package: Package) -> list[Need]:
        """What a package needs and declares neither itself nor through packages of the workspace, once by name."""
        return [needs[0] for needs in self._undeclared.get(package.name, {}).values()]

    def places(self, need: Need) -> list[Need]:
        """All uses of what is needed, those first that are for the robot in any case."""
        return self._undeclared[need.owner.name][str(need.name)]

    @cached_property
    def _undeclared(self) -> dict[str, dict[str, list[Need]]]:
        found: dict[str, dict[str, list[Need]]] = {}
        for need in self._needs():
            found.setdefault(need.owner.name, {}).setdefault(str(need.name), []).append(need)
        for uses in (uses for needs in found.values() for uses in needs.values()):
            uses.sort(key=lambda use: not use.always)
        return found

    def _needs(self) -> Iterator[Need]:
        for needs in _NEEDS:
            for need in needs(self._files, self._launch):
                owner = need.owner
                if need.name == owner.name or owner.depends_on(need.name):
                    continue
                if owner.manifest.for_both and need.use == "library":
                    continue
                yield need._replace(by_others=need.name in self._required(owner))

    @memo
    def _required(self, package: Package) -> frozenset[str]:
        return frozenset(map(str, self._launch.workspace.required(package)))

    def judged(self, package: Package) -> bool:
        """Whether the tree's authors wrote the package, for ROS 2 alone and for the robot."""
        return not package.manifest.for_both and self._is_own_of(package, Purpose.ROBOT)

    def must_declare(self, package: Package) -> bool:
        """Whether the tree's authors wrote the package for ROS 2: one for a simulation or of examples is built and
        started like others."""
        return self._is_own_of(package, Purpose.ROBOT, Purpose.EXAMPLE, Purpose.SIMULATION, Purpose.TEST)

    def is_for_robot(self, package: Package) -> bool:
        """Whether a package is for more than simulations and tests."""
        return self._files.purpose(package.manifest.source) in (Purpose.ROBOT, Purpose.EXAMPLE)

    def _is_own_of(self, package: Package, *purposes: Purpose) -> bool:
        manifest = package.manifest
        if not manifest.source.judged or manifest.is_ros1 or _FOREIGN.search(package.name):
            return False
        is_vendored = self._launch.workspace.is_vendored(manifest.source)
        return self._files.purpose(manifest.source) in purposes and not is_vendored

    @property
    def manifests(self) -> list[Manifest]:
        """Each package.xml, also those of packages that others wrote and that have the same name as another, but none
        that tests read."""
        from bringup_lint.parsers import package_xml

        found = self._files.parsed(package_xml.parse, self._files.of_kind("ros-package"))
        return [each for each in found if each.source.judged and not self._files.is_test_data(each.source)]

    def misspelt_words(self, package: Package) -> Iterator[MisspeltBuild]:
        """Words of the CMakeLists.txt of a package that mean nothing, and that are a letter away from one that does."""
        from bringup_lint.graph.dependencies.misspelt_builds import misspelt_words

        manifest = package.manifest
        is_judged = manifest.source.judged and not self._files.is_test_data(manifest.source)
        return misspelt_words(self._launch.workspace, package) if is_judged else iter(())

    def old_minimums(self, package: Package) -> Iterator[tuple[str, Located]]:
        """The versions of CMake that a package asks for, and that CMake 4 refuses, each with its command."""
        from bringup_lint.graph.dependencies.old_minimums import old_minimums

        return old_minimums(package) if package.manifest.source.judged else iter(())

    def differing_version(self, package: Package) -> tuple[Located, Located] | None:
        """The version of a Python package in setup.py, and another one in package.xml."""
        from bringup_lint.graph.dependencies.differing_version import differing_version

        return differing_version(package)

    @property
    def unread_settings(self) -> Iterator[UnreadSetting]:
        """Lines of setup.cfg that setuptools refuses, or that it does not read as they are meant."""
        sources = self._files.of_kind("setup-cfg")
        if not sources:
            return iter(())
        from bringup_lint.graph.dependencies.setup_settings import unread_settings

        return unread_settings(self.manifests, sources, self._own)

    def missing_files(self, package: Package) -> list[Install]:
        """What a build installs in any case, and that is not in the tree."""
        return missing_files(self._files, package)

    def idle_globs(self, package: Package) -> Iterator[IdleGlob]:
        """The globs of a package that match nothing, where files are left out."""
        return idle_globs(self._launch, package)

    def plain_programs(self, package: Package) -> Iterator[Install]:
        """The installed scripts of a package that do not say which interpreter they are for."""
        return plain_programs(self._files.tree, package, self.started_programs(package))

    def programs_without_mode(self, package: Package) -> Iterator[Located]:
        """The scripts that a package installs as programs without the mode of one, and that no launch file starts."""
        return programs_without_mode(self._files.tree, package, self.started_programs(package))

    def unplaced_programs(self, package: Package) -> Iterator[Located]:
        """The nodes that CMake installs where ``ros2 run`` does not look, and that no launch file starts."""
        return unplaced_programs(self._files.tree, package, self.started_programs(package))

    def started_programs(self, package: Package) -> dict[str, Span]:
        """The programs of a package that launch files start, and where."""
        return self._started_programs.get(package.name, {})

    def starts_by_default(self, package: Package, program: str) -> bool:
        """Whether a launch file starts a program of a package when no argument is passed."""
        return (package.name, program) in self._default_programs

    @cached_property
    def _default_programs(self) -> frozenset[tuple[str | None, str | None]]:
        by_default = (node for node in self._launch.nodes if node.by_default is True)
        return frozenset((literal_text(node.package), literal_text(node.executable)) for node in by_default)

    @cached_property
    def _started_programs(self) -> dict[str, dict[str, Span]]:
        found: dict[str, dict[str, Span]] = {}
        for node in self._launch.nodes:
            owner, name = literal_text(node.package), literal_text(node.executable)
            if owner is not None and name is not None:
                found.setdefault(str(owner), {}).setdefault(str(name), name.span)
        return found

    def ros1_programs(self, package: Package) -> Iterator[Install]:
        """The programs of ROS 1 that a package of ROS 2 installs."""
        return ros1_programs(self._files.tree, package)

    def left_out_modules(self, package: Package) -> Iterator[LeftOut]:
        """What a Python package imports of itself, and does not install."""
        return left_out(self._files.tree, package)

    def left_beside(self, package: Package) -> Iterator[LeftBeside]:
        """What the scripts of a package import from their own folder, and CMake does not install there."""
        return left_beside(self._files.tree, package)

    def data_beside(self, package: Package) -> Iterator[Beside]:
        """What the console scripts of a Python package look for beside their modules, and that setuptools does
        not install."""
        from bringup_lint.graph.dependencies.data_beside import data_beside

        return data_beside(self._files.tree, package)

    def leads_to_source(self, package: Package) -> bool:
        """Whether the tree builds a package with links to the source, where nothing is missing that is not installed:
        it says so, and no script or image builds it without."""
        return self._installers.mentions_symlinks and not any(
            f"{package.folder}/".startswith(folder) and (_SELECTS not in command or package.name in command.split())
            for folder, command in self._unlinked_builds
        )

    @cached_property
    def _unlinked_builds(self) -> list[tuple[str, str]]:
        """The commands of scripts and images that build without links to the source, each with the folder of which it
        builds the packages: its own where that holds packages, as in a repository that the tree has a copy of."""
        sources = (
            each
            for each in self._files.of_kind("dockerfile", "shell-script")
            if each.judged and self._files.purpose(each) is not Purpose.CI
        )
        builds = ((each, command) for each in sources for command in _BUILDS.findall(each.uncommented))
        folders = [f"{each.folder}/" for each in self._launch.workspace.packages.values()]
        return [
            (own if any(each.startswith(own) for each in folders) else "", command)
            for source, command in builds
            if "--symlink" not in command and (own := f"{os.path.dirname(source.absolute)}/")
        ]

    def unexported(self, package: Package) -> Iterator[Unexported]:
        """The descriptions of plugins that a package builds and does not export."""
        return unexported(self._files, package)

    def unloadable(self, package: Package) -> Iterator[Unloadable]:
        """The plugins that pluginlib does not load, because their description and the build do not agree."""
        return unloadable(self._files, self._launch.workspace, package)

    def unregistered(self, package: Package) -> Iterator[Unregistered]:
        """The components that the build of a package names as no source of it registers them."""
        return unregistered(self._files, self._launch, package)

    @property
    def missing_interfaces(self) -> Iterator[MissingInterface]:
        """The imports of messages, services and actions that the packages of the workspace do not have."""
        return missing_interfaces(self._files, self._launch.workspace, self._interfaces_of)

    @property
    def ungenerated(self) -> Iterator[Ungenerated]:
        """The packages whose messages, services and actions are not generated, or make the build fail."""
        return ungenerated(self._files, self._launch.workspace, self._interfaces_of)

    @property
    def refused_definitions(self) -> Iterator[RefusedDefinition]:
        """The messages, services and actions from which rosidl makes no code."""
        from bringup_lint.graph.dependencies.interface_lines import refused_definitions

        return refused_definitions(self._files, self._launch.workspace, self._interfaces_of)

    @memo
    def _interfaces_of(self, package: Package) -> PackageInterfaces:
        return PackageInterfaces(self._files.tree, package)

    @property
    def misspelt_packages(self) -> Iterator[MisspeltPackage]:
        """The names of packages in launch files, nodes and descriptions that are nearly the name of one."""
        return misspelt_packages(self._files, self._launch, self.is_fetched)

    def is_of_workspace(self, need: Need) -> bool:
        """Whether a package of the tree is needed."""
        return need.name in self._own

    def stops_build(self, need: Need) -> bool:
        """Whether CMake asks for a package of the same workspace: colcon builds in an environment of those packages
        that package.xml declares, and of no others."""
        return need.use == "library" and self.is_built_beside(need)

    def is_built_beside(self, need: Need) -> bool:
        """Whether a package of the same source space is needed, which nothing fetches from elsewhere."""
        needed = self._launch.workspace.packages.get(str(need.name))
        if needed is None or self._provided.has_repository(str(need.name)):
            return False
        return _source_space(needed.folder) == _source_space(need.owner.folder)

    def is_lacking(self, need: Need) -> bool:
        """Whether a public package is needed on the robot that ros-base lacks, and nothing of the tree declares,
        installs or mentions it."""
        known = need.fact
        if known is None or not need.always or need.name in base() or self.is_of_workspace(need):
            return False
        if any(known.comes_with(name) for name in self._declared):
            return False
        if need.use == "module" and self._asks_for_others(need.owner):
            return False
        return not self._is_example(need) and not self._provided.brings(known)

    def is_unheard_of(self, need: Need) -> bool:
        """Whether no table and nothing else of the tree knows a package, and none of the tree has a name of its family:
        it may have another name now, and rosdep stops where a package.xml declares it."""
        name = str(need.name)
        if need.use in ("module", "program", "library", "interfaces"):
            return False
        is_known = need.fact is not None or name in released() or name in base() or is_known_package(name)
        is_known = is_known or name.partition("_")[0] in self._families
        return not (is_known or self.is_of_workspace(need) or name in self._declared or self.is_fetched(name))

    def is_installed(self, need: Need) -> bool:
        """Whether something of the tree installs a module or a library that is no package of ROS."""
        return need.fact is not None and not need.fact.is_package and self._provided.installs(need.fact)

    def is_fetched(self, name: str) -> bool:
        """Whether a list of repositories or a command names a package as one of others."""
        return self._provided.has_repository(name)

    def is_forked(self, package: str) -> bool:
        """Whether the tree fetches a public package from others than those who release it: it may be changed."""
        return self._provided.has_fork(package)

    def is_kept_before(self, package: str, release: str) -> bool:
        """Whether the tree fetches a public package from others, or an older release of it than one."""
        return self.is_forked(package) or self._provided.fetches_older(package, release)

    def left_out(self, need: Need) -> Located | None:
        """The command that builds a package without another one of the workspace that its launch files start."""
        name = str(need.name)
        is_started = need.use in ("node", "include") and name in self._launch.workspace.packages
        if not is_started or self._provided.has_repository(name):
            return None
        return self._apart.leaving_out(need.owner, name)

    @cached_property
    def _apart(self) -> Apart:
        return Apart(self._files, self._launch.workspace)

    def _asks_for_others(self, package: Package) -> bool:
        """Whether nodes import what no table knows: it may bring further modules. Where the tree says of no package how
        it is installed, those of all packages count."""
        packages = [package] if self.uses_rosdep else self._launch.workspace.packages.values()
        return any(self._asks_for_unknown(each) for each in packages)

    @memo
    def _asks_for_unknown(self, package: Package) -> bool:
        asked = (need for need in self.undeclared(package) if need.use == "module" and not need.by_others)
        return not all(self._is_there(str(need.name)) for need in asked if need.fact is None)

    def _is_there(self, module: str) -> bool:
        """Whether a module is one of Python, of ros-base, of messages or of the workspace."""
        return (
            module.endswith(("_msgs", "_interfaces"))
            or module in sys.stdlib_module_names
            or module in base()
            or module in self._own
            or module in _COMMON
        )

    def _is_example(self, need: Need) -> bool:
        """Whether a launch file is called like what it starts, and nothing else of the tree names it: it shows how to
        use another package."""
        source = need.name.span.source
        family = str(need.name).split("_")[0]
        if str(need.name) not in source.basename and (len(family) < 7 or family not in source.basename):
            return False
        file = self._launch.of_source(source)
        return file is not None and not self._launch.is_named_elsewhere(file)

    @cached_property
    def _declared(self) -> frozenset[str]:
        """What rosdep installs for the whole workspace, and the packages of which there are several."""
        workspace = self._launch.workspace
        depends = (name for package in workspace.packages.values() for _, name in package.manifest.depends)
        return frozenset(map(str, depends)) - workspace.packages.keys() | frozenset(workspace.ambiguous)

    @cached_property
    def _families(self) -> frozenset[str]:
        """The first words of the names of packages."""
        return frozenset(name.partition("_")[0] for name in self._own)

    @cached_property
    def _own(self) -> frozenset[str]:
        workspace = self._launch.workspace
        return frozenset(workspace.packages) | frozenset(workspace.ambiguous)

    @cached_property
    def _installers(self) -> Installers:
        return Installers(self._files.tree)

    @cached_property
    def _provided(self) -> Provided:
        return Provided(self._installers, self._dockerfiles())

    @cached_property
    def uses_rosdep(self) -> bool:
        """Whether scripts or images of the tree install with rosdep, or the documentation at its top."""
        return bool(self._rosdep_commands)

    @cached_property
    def _rosdep_commands(self) -> list[str]:
        sources = self._files.of_kind("dockerfile", "shell-script", "ansible")
        own = [command for source in sources for command in ROSDEP.findall(source.text)]
        return own + self._installers.rosdep_commands

    def stops_rosdep(self, name: str) -> bool:
        """Whether rosdep installs nothing when a name cannot be resolved, in each command of the tree: one that goes on
        may be the one for this workspace. Where the tree has no command, it is the one that people type, unless scripts
        or images install with something else."""
        if not self._rosdep_commands:
            return not self._installers.mentions_rosdep and not self._installs_without_rosdep
        commands = [command for command in self._rosdep_commands if "--from-path" in command]
        return bool(commands) and not any(_GOES_ON.search(command) or name in command for command in commands)

    @cached_property
    def _installs_without_rosdep(self) -> bool:
        """Whether scripts or images of the tree install packages."""
        sources = self._files.of_kind("dockerfile", "shell-script", "ansible")
        return any(each.says(_INSTALLS) for each in sources)

    def skips(self, name: str) -> bool:
        """Whether a command of the tree tells rosdep to leave out a name."""
        return any(name in command for command in self._rosdep_commands)

    def rosdep_goes_on_without(self, name: str, instead: str) -> bool:
        """Whether the commands of the tree go on when a name cannot be resolved, and nothing else declares or installs
        what the name stands for."""
        if not self._rosdep_commands or self.skips(name):
            return False
        meant = of_key(instead)
        is_there = instead in base() or instead.removeprefix("python3-") in _COMMON
        brings = is_there or any(map(meant.comes_with, self._declared - {name}))
        also = name.replace("-", "_")
        return not brings and not self._provided.brings(meant._replace(also=(*meant.also, also)))

    def unresolved(self) -> Iterator[Located]:
        """The dependencies of packages of ROS 2 that rosdep does not know, and that the tree does not have."""
        for package in self._launch.workspace.packages.values():
            if self.judged(package) and package.manifest.build_type.startswith("ament_"):
                yield from (name for _, name in package.manifest.depends if self._is_unresolved(name))

    @property
    def misspelt_dependencies(self) -> Iterator[MisspeltDependency]:
        """Dependencies in package.xml that nobody has, and that are a letter away from one that somebody has."""
        from bringup_lint.graph.dependencies.misspelt_depends import misspelt_dependencies

        return misspelt_dependencies(self._launch.workspace, self.manifests, self.is_fetched)

    def _is_unresolved(self, name: Located) -> bool:
        if name in self._own or instead_of(name) is None:
            return False
        if "condition=" in name.span.source.line_text(name.span.line):
            return False
        if unresolved(name).ended and self._files.target.ros in _OF_FOCAL:
            return False
        return name in not_rosdep() or not self._provided.has_repository(name)


def _source_space(folder: str) -> str:
    """The uppermost folder of packages: those of another one are built before, or after."""
    above, src, _ = folder.partition("/src/")
    return above if src else ""
