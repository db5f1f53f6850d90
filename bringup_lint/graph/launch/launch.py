"""The launch layer: all launch files of the tree, what each leads to, and the nodes that really start."""

from __future__ import annotations

import os
import re
from collections.abc import Callable
from collections.abc import Iterator
from functools import cached_property
from typing import TYPE_CHECKING
from typing import TypeVar

from bringup_lint.discover.kinds.launch import LAUNCH
from bringup_lint.facts.ros.node_roles import Role
from bringup_lint.facts.ros.node_roles import role_of
from bringup_lint.facts.ros.simulation import is_simulation
from bringup_lint.graph.launch.expand import ACTIONS
from bringup_lint.graph.launch.expand import Expander
from bringup_lint.graph.launch.expansion import Expansion
from bringup_lint.graph.launch.references import Reference
from bringup_lint.graph.launch.references import references
from bringup_lint.graph.launch.resolve import Resolver
from bringup_lint.graph.launch.resolve import text_of
from bringup_lint.graph.launch.scope import Scope
from bringup_lint.graph.launch.started import Started
from bringup_lint.graph.launch.started import literal_text
from bringup_lint.graph.launch.unknown_folders import missing_everywhere
from bringup_lint.graph.launch.visits import VISITS
from bringup_lint.graph.memo import memo
from bringup_lint.graph.purpose import Purpose
from bringup_lint.graph.workspace import Found
from bringup_lint.graph.workspace import Package
from bringup_lint.graph.workspace import Place
from bringup_lint.graph.workspace import Workspace
from bringup_lint.graph.workspace import load_workspace
from bringup_lint.graph.workspace import place
from bringup_lint.model.launch import Action
from bringup_lint.model.launch import Include
from bringup_lint.model.launch import LaunchFile
from bringup_lint.model.launch import walk_actions
from bringup_lint.model.launch_values import Condition
from bringup_lint.model.launch_values import Value
from bringup_lint.pattern import regex
from bringup_lint.source import Located
from bringup_lint.source import Source

if TYPE_CHECKING:
    from bringup_lint.graph.files import Files
    from bringup_lint.graph.launch.grammar import Refusal

_REMARK = regex(r"#[^\n]*")
_VIEW = regex(r"(?:^|[/_.-])(?:display|view\w*|rviz\w*)(?:$|[/_.-])")
"""Paths of launch files that only show something."""
_RAISES = ("path", "added", "number")
"""Uses of a launch configuration that end with a TypeError."""
_LAUNCH_FILE = regex(r"(?<![\w.-])(?:[\w.-]+\.launch(?:\.(?:py|xml|ya?ml))?|[\w.-]+_launch\.py)")
EXPANSIONS = 2_000
"""Entries that are expanded in one run."""
ACTIONS_OF_RUN = 100
"""How often an action is expanded in one run, on average over all launch files."""
MINIMUM_OF_RUN = 50_000
"""Actions that are expanded in one run in any case."""


Kind = TypeVar("Kind", bound=Action)


class Launch:
    """Every launch file of ROS 2 in the tree, and the expansion of each, with the file as the entry."""

    def __init__(self, files: Files) -> None:
        self.files = files

    @cached_property
    def launch_files(self) -> list[LaunchFile]:
        """The launch files of ROS 2 in the tree."""
        return [file for source in self.files.of_kind(*LAUNCH) for file in self._parsed(source)]

    def _parsed(self, source: Source) -> list[LaunchFile]:
        return self.files.parsed(_parser(source.kind), [source])

    @cached_property
    def _by_path(self) -> dict[str, LaunchFile]:
        return {file.source.absolute: file for file in self.launch_files}

    def of_source(self, source: Source) -> LaunchFile | None:
        """The launch file that a source is."""
        return self._by_source.get(source)

    @cached_property
    def _by_source(self) -> dict[Source, LaunchFile]:
        return {file.source: file for file in self.launch_files}

    @cached_property
    def workspace(self) -> Workspace:
        return load_workspace(self.files)

    @property
    def judged(self) -> list[LaunchFile]:
        """Those that findings may be about: not context, not templates, nothing in packages of ROS 1."""
        return self._judged

    @cached_property
    def _judged(self) -> list[LaunchFile]:
        files = [file for file in self.launch_files if file.source.judged and not file.source.template]
        owners = [self.workspace.owner(file.source) for file in files]
        return [file for file, owner in zip(files, owners) if owner is None or not owner.manifest.is_ros1]

    @memo
    def place(self, value: Value) -> Place | None:
        """A resolved value as a path, in terms of the package or folder it is relative to."""
        return place(value)

    def find(self, value: Value) -> Found | None:
        """The file that a resolved value names; None when the tree cannot tell."""
        return self.workspace.find(self.place(value))

    def find_or_miss(self, value: Value) -> Found | None:
        """As ``find``; where it cannot tell, because folders or the installation are not known, whether the tree has no
        file of this name at all."""
        return self.find(value) or missing_everywhere(value, self.workspace)

    def never_runs(self, node: Started) -> bool:
        """Whether the package of a node, which is in the tree, surely has no such executable. One that is built and
        only not installed is meant to run."""
        package = self.workspace.packages.get(literal_text(node.package) or "")
        executable = literal_text(node.executable)
        if package is None or executable is None:
            return False
        return package.made(executable) is None and self.workspace.lacks(package, executable)

    def locate(self, value: Value) -> LaunchFile | None:
        """The launch file that a resolved value names, if it is in the tree."""
        found = self.find(value)
        if found is None or found.file is None:
            return None
        return self._by_path.get(found.file) or self._by_path.get(self.files.tree.real_path(found.file))

    @cached_property
    def _mentions(self) -> dict[str, set[int]]:
        found: dict[str, set[int]] = {}
        for file in self.launch_files:
            for name in _LAUNCH_FILE.findall(file.source.text):
                found.setdefault(name, set()).add(id(file))
        return found

    def is_named_elsewhere(self, file: LaunchFile) -> bool:
        """Whether another launch file speaks of a file of this name, so that it may include it in a way that is not
        known."""
        name = file.source.basename
        for other in self._mentions.get(name, set()) - {id(file)}:
            meant = self._meant.get((other, name))
            if meant is None or id(file) in meant:
                return True
        return False

    @cached_property
    def included(self) -> set[int]:
        """Files (by ``id``) that another file of the tree includes by a name that is known without running."""
        return {each for targets in self._meant.values() for each in targets}

    def is_left_over(self, file: LaunchFile) -> bool:
        """Whether nothing includes a launch file that lies in a folder where others are only there to be included."""
        beside = self._by_folder[os.path.dirname(file.source.absolute)]
        return id(file) not in self.included and 2 * len(self.included.intersection(beside)) >= len(beside)

    @cached_property
    def _by_folder(self) -> dict[str, list[int]]:
        found: dict[str, list[int]] = {}
        for file in self.launch_files:
            found.setdefault(os.path.dirname(file.source.absolute), []).append(id(file))
        return found

    @cached_property
    def _meant(self) -> dict[tuple[int, str], set[int]]:
        """File (by ``id``) and name of a launch file -> the files of this name that it is known to include."""
        found: dict[tuple[int, str], set[int]] = {}
        resolver = Resolver(Scope())
        for file in self.launch_files:
            for action in walk_actions(file.actions):
                if isinstance(action, Include):
                    target = self.locate(resolver.value(action.file))
                    if target is not None and target is not file:
                        found.setdefault((id(file), target.source.basename), set()).add(id(target))
        return found

    @cached_property
    def _all(self) -> dict[int, Expansion]:
        return {id(file): self.expand(file) for file in self.launch_files[:EXPANSIONS]}

    @property
    def expansions(self) -> Iterator[Expansion]:
        """Every launch file as an entry of its own, started without arguments."""
        return iter(self._all.values())

    @property
    def entries(self) -> Iterator[Expansion]:
        """Only the files that no other file includes."""
        return (self._all[id(file)] for file in self.launch_files[:EXPANSIONS] if id(file) not in self.included)

    def leading_to(self, file: LaunchFile) -> Iterator[Expansion]:
        """The expansions in which a file is read."""
        return iter(self._leading.get(id(file), ()))

    @cached_property
    def _leading(self) -> dict[int, list[Expansion]]:
        found: dict[int, list[Expansion]] = {}
        for expansion in self.expansions:
            for file in expansion.files:
                found.setdefault(id(file), []).append(expansion)
        return found

    def expansion(self, file: LaunchFile) -> Expansion:
        return self._all.get(id(file)) or self.expand(file)

    def expand(self, file: LaunchFile, arguments: dict[str, Value] | None = None) -> Expansion:
        """What a file leads to when it is launched with these arguments."""
        limit = min(ACTIONS, self._actions_left)
        expander = Expander(file, VISITS, self.locate, limit)
        expansion = expander.run(arguments or {})
        self._actions_left -= expander.count
        return expansion

    @cached_property
    def _actions_left(self) -> int:
        """How many actions may still be expanded in this run: enough for every file to be included many times."""
        return max(
            MINIMUM_OF_RUN, ACTIONS_OF_RUN * sum(1 for file in self.launch_files for _ in walk_actions(file.actions))
        )

    @property
    def nodes(self) -> Iterator[Started]:
        """Every node of every file once, as its own file starts it when it is launched directly."""
        return iter(self._nodes)

    @cached_property
    def _nodes(self) -> list[Started]:
        return [node for each in self.expansions for node in each.nodes if node.file is each.entry]

    @cached_property
    def ros1(self) -> list[LaunchFile]:
        """Files in the syntax of ROS 1, read as if they were of ROS 2."""
        from bringup_lint.parsers.launch_xml import parse

        return self.files.parsed(parse, self.files.of_kind("launch-ros1"))

    @memo
    def references(self, file: LaunchFile) -> list[Reference]:
        """The files that a launch file names through a package or beside itself, when launched without arguments."""
        return list(references(self.expansion(file), file, self.find_or_miss))

    def missing(self, kind: str) -> Iterator[tuple[Reference, Package]]:
        """The files of a kind that launch files name and that do not exist in a package of the tree."""
        for file in self.judged:
            for each in self.references(file):
                if each.kind == kind and each.found.file is None and each.name and each.found.package is not None:
                    yield each, each.found.package

    @memo
    def refusals(self, file: LaunchFile) -> list[Refusal]:
        """What launch refuses in an XML or YAML file; without names that an extension in the tree may define."""
        from bringup_lint.graph.launch.grammar import refusals

        of_ros1 = {name.span.start for name in file.ros1}
        renamed = any(name in ("type", "value") for name in file.ros1)
        every = refusals(file, self.files.target.ros)
        found = [each for each in every if not _is_ros1(each, of_ros1, renamed)]
        if any(each.extension for each in found) and self._extends_launch:
            found = [each for each in found if not each.extension]
        return found

    @cached_property
    def _extends_launch(self) -> bool:
        """Whether a package of the tree adds tags or substitutions to launch."""
        builds = self.files.of_kind("setup-py", "setup-cfg")
        return any("launch.frontend.launch_extension" in source.text for source in builds)

    def ends_at_once(self, file: LaunchFile) -> bool:
        """Whether a Python file takes a launch configuration for a path, a text or a number, and so starts nothing."""
        return any(each.how in _RAISES for each in file.objects)

    def files_of(self, package: Package) -> list[LaunchFile]:
        """The launch files that lie in a package."""
        return self._by_package.get(id(package), [])

    @cached_property
    def _by_package(self) -> dict[int, list[LaunchFile]]:
        found: dict[int, list[LaunchFile]] = {}
        for file in self.launch_files:
            found.setdefault(id(self.workspace.owner(file.source)), []).append(file)
        return found

    @memo
    def role(self, node: Started) -> Role:
        """What is known about a node's program."""
        return role_of(literal_text(node.package), node.program, self.files.target.ros)

    @memo
    def simulated(self, file: LaunchFile) -> bool:
        """Whether a launch file is for a simulator, a test or a look at a model: by its path, or by what it starts."""
        if self.files.purpose(file.source) is not Purpose.ROBOT or _VIEW.search(file.source.name):
            return True
        expansion = self.expansion(file)
        packages = {str(literal_text(node.package)) for node in expansion.nodes if node.by_default is not False}
        always = (self.place(include.file) for include in expansion.includes if not include.conditions)
        packages |= {target.package for target in always if target is not None}
        return any(map(is_simulation, packages))

    def visited(self, file: LaunchFile) -> Iterator[tuple[Action, LaunchFile]]:
        """The actions of a file itself, as it is launched without arguments."""
        return (pair for pair in self.expansion(file).actions if pair[1] is file)

    def resolved(self, value: Value | None, file: LaunchFile) -> Value | None:
        """A value when its file is launched without arguments."""
        return Resolver(Scope(self.expansion(file).arguments)).optional(value)

    def named(self, package: str | None, target: str | None) -> LaunchFile | None:
        """The file that ``ros2 launch package target`` starts; a path when there is no package."""
        if not target:
            return None
        if package is None:
            found = self._by_name.get(target.rpartition("/")[2], [])
        else:
            owner = self.workspace.packages.get(str(package))
            called = self._by_name.get(target, [])
            found = [file for file in called if self.workspace.owner(file.source) is owner]
        return found[0] if len(found) == 1 else None

    @cached_property
    def _by_name(self) -> dict[str, list[LaunchFile]]:
        """The launch files by the last parts of their paths."""
        found: dict[str, list[LaunchFile]] = {}
        for file in self.launch_files:
            found.setdefault(file.source.basename, []).append(file)
        return found

    def conditions(self, file: LaunchFile) -> Iterator[Condition]:
        """Every condition in a file, of actions and components."""
        for action in walk_actions(file.actions):
            yield from action.conditions

    def is_unrun_test(self, source: Source) -> bool:
        """Whether a launch file is one for tests that the build of its package does not name."""
        owner = self.workspace.owner(source)
        if self.files.purpose(source) is not Purpose.TEST or owner is None or not owner.builds:
            return False
        return not any(source.basename in _REMARK.sub("", each.source.text) for each in owner.builds)

    def mentions(self, file: LaunchFile, name: str) -> int:
        """How often a name is in a file's text as a word of its own."""
        return len(re.findall(rf"(?<![\w]){re.escape(name)}(?![\w])", file.source.text))

    def text(self, value: Value, file: LaunchFile) -> str | None:
        """A value as text when the file is launched without arguments; None when that is not known."""
        return text_of(Resolver(Scope(self.expansion(file).arguments)).value(value))

    def actions(self, kind: type[Kind]) -> Iterator[tuple[LaunchFile, Kind]]:
        """All actions of a kind in the judged files, with their file."""
        for file in self.judged:
            for action in walk_actions(file.actions):
                if isinstance(action, kind):
                    yield file, action


def _is_ros1(refusal: Refusal, starts: set[int], renamed: bool) -> bool:
    """Whether a construct of ROS 1 is the cause, which is found as such: one that starts there, or an attribute that
    has another name now."""
    where = refusal.where.span if isinstance(refusal.where, Located) else refusal.where
    return where.start in starts or (refusal.code == "missing" and renamed)


def _parser(kind: str) -> Callable[[Source], LaunchFile]:
    if kind == "launch-python":
        from bringup_lint.parsers.launch_python import parse
    elif kind == "launch-xml":
        from bringup_lint.parsers.launch_xml import parse
    else:
        from bringup_lint.parsers.launch_yaml import parse
    return parse
