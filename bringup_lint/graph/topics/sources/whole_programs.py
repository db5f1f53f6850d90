"""Whether the sources of a C++ program say every end of a topic that it makes."""

from __future__ import annotations

import os
from functools import partial
from typing import TYPE_CHECKING

from bringup_lint.endings import CPP_SOURCES
from bringup_lint.facts.ros.brought import is_released
from bringup_lint.facts.ros.topic_makers import may_make_topics
from bringup_lint.graph.memo import memo
from bringup_lint.graph.topics.sources.cpp_files import CppFiles
from bringup_lint.graph.topics.sources.cpp_files import stem
from bringup_lint.graph.workspace import Package
from bringup_lint.graph.workspace import Workspace
from bringup_lint.model.cpp_source import CppNode
from bringup_lint.model.cpp_text import plain_of
from bringup_lint.pattern import regex
from bringup_lint.source import Source

if TYPE_CHECKING:
    from collections.abc import Iterable

MOST = 200
"""Files of one program that are looked at."""
_MADE = regex(r"\bcreate_(?:publisher|subscription|service|client|server)\b", hints="create_")
_UNSEEN = regex(
    r"\bcreate_generic_\w|\bGeneric(?:Publisher|Subscription)\b|\b(?:Publisher|Subscription)Factory\b|\bwait_for_message\b"
    r"|\bSubscriber\s{0,4}<|\b(?:image|point_cloud)_transport::|\bnamespace\s{1,4}(?:image|point_cloud)_transport\b"
    r"|\bComponentManager\b|\brcl_(?:publisher|subscription)_init|\brclc_\w|\bcreate(?:Shared|Unique)Instance\b"
    r"|\bdlopen\b",
    hints="create_generic_ Generic Factory Subscriber _transport wait_for_message ComponentManager rcl_ rclc_ Instance "
    "dlopen",
)
"""What makes ends that no call above writes, and what loads code that is not known."""
_COMPONENT = "RCLCPP_COMPONENTS_REGISTER_NODE"
_HARMLESS = regex(r"\w+/(?:msg|srv|action)/|pluginlib/class_list_macros|pcl_ros/transforms")
"""Headers of packages that may make topics, which make none."""


class WholePrograms:
    """Follows what the files of a program include."""

    def __init__(self, files: CppFiles, workspace: Workspace) -> None:
        self._files = files
        self._workspace = workspace

    def is_whole(self, package: Package, target: str, nodes: Iterable[CppNode]) -> bool:
        """``target``: an executable, or the library of a component; ``nodes``: the files whose ends are known."""
        known = {node.source.absolute: node for node in nodes}
        made = {path for path in _made(package, target) or () if path in known or not self._registers(path)}
        paths = self._reached(package, made) if made else None
        if paths is None:
            return False
        sources = [(path, self._files.source(path)) for path in sorted(paths)]
        return all(source is not None and _is_told(source, known.get(path)) for path, source in sources)

    def _registers(self, path: str) -> bool:
        """Whether a file is that of a component: of one library, each is made by itself."""
        source = self._files.source(path)
        return source is not None and _COMPONENT in source.text

    def _reached(self, package: Package, made: set[str]) -> set[str] | None:
        """The files that a program is made of, and all of the workspace that they include; None when part of that is
        not known, or when what they include from elsewhere may make topics."""
        depends = {str(name) for _, name in package.manifest.depends}
        found: set[str] = set()
        linked: set[Package] = {package}
        asked: set[tuple[Package, str]] = set()
        todo = [(path, package) for path in made]
        while todo:
            path, owner = todo.pop()
            if path in found:
                continue
            found.add(path)
            source = self._files.source(path)
            if source is None or len(found) > MOST:
                return None
            for included in self._files.includes(path):
                name = included.partition("/")[0]
                packages = self._workspace.packages
                other = packages.get(name, owner)
                if name in self._workspace.ambiguous or (name not in packages and _is_open(included, depends)):
                    return None
                beside = self._files.by_stem(other).get(stem(included), ())
                if (name == ".." and not beside) or len(beside) > MOST:
                    return None
                if other is not owner and other not in linked:
                    linked.add(other)
                    depends.update(str(each) for _, each in other.manifest.depends)
                    compiled = self._compiled(other)
                    if len(compiled) > MOST:
                        return None
                    todo += ((each, other) for each in compiled)
                if (other, stem(included)) not in asked:
                    asked.add((other, stem(included)))
                    todo += ((each, other) for each in beside)
        return found

    @memo
    def _compiled(self, package: Package) -> list[str]:
        """What is compiled in a package, without its programs."""
        return [each for each in self._files.of_package(package, CPP_SOURCES) if not self._files.is_program(each)]


def _is_open(included: str, depends: set[str]) -> bool:
    """Whether a header that is not of the workspace may make topics: one of a package of ROS."""
    name, slash, _ = included.partition("/")
    if not slash or _HARMLESS.match(included):
        return False
    return (name in depends or is_released(name)) and may_make_topics(name)


def _made(package: Package, target: str) -> set[str] | None:
    """The sources of a target, and of all of its package that it links; None when some are not known."""
    found: set[str] = set()
    todo, seen = [target], {target}
    while todo:
        current = todo.pop()
        for build in package.builds:
            if current in build.open_targets:
                return None
            folder = os.path.dirname(build.source.absolute)
            found.update(os.path.normpath(os.path.join(folder, file)) for file in build.targets.get(current, ()))
            new = [name for name in build.links.get(current, ()) if name not in seen]
            seen.update(new)
            todo += new
    return found


def _is_told(source: Source, node: CppNode | None) -> bool:
    """Whether every end that a file makes is known with its name, or with the parameter that gives it."""
    made = source.once(_ends, partial(_ends, source))
    if not made:
        return made == 0
    named = [each for each in node.endpoints if each.name or each.parameter] if node is not None else []
    return node is not None and not node.problems and made == len(named)


def _ends(source: Source) -> int | None:
    """How many ends a file makes; None when it may make some unseen."""
    plain = plain_of(source)
    return None if _UNSEEN.search(plain) else len(_MADE.findall(plain))
