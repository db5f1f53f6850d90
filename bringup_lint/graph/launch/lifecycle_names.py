"""The names of nodes as lifecycle managers and programs use them: what is started, managed and switched."""

from __future__ import annotations

import re
from collections.abc import Iterable
from collections.abc import Iterator
from typing import TYPE_CHECKING

from bringup_lint.graph.launch.lifecycle import full_name
from bringup_lint.graph.launch.lifecycle import managers
from bringup_lint.graph.launch.packages import code_of
from bringup_lint.graph.launch.resolve import text_of
from bringup_lint.graph.launch.started import literal_text
from bringup_lint.graph.memo import kept
from bringup_lint.pattern import regex

if TYPE_CHECKING:
    from bringup_lint.graph.launch.expansion import Expansion
    from bringup_lint.graph.launch.launch import Launch
    from bringup_lint.graph.launch.started import Started
    from bringup_lint.model.launch import LaunchFile
    from bringup_lint.source import Span

_LIFECYCLE = regex(r"lifecycle|nav2_util|nav2_ros_common")
_PROGRAMS = ("python-node", "cpp-node", "shell-script", "systemd-unit", "compose", "dockerfile")
_SWITCHES = regex(r"\blifecycle[\"',\s]+set\b|\blifecycle_bringup\b|\bChangeState\b|/change_state\b")
"""Commands and service clients that configure the nodes which their file names."""
_SWITCH_WORDS = ("lifecycle", "ChangeState", "change_state")
"""One of them is in each text that the pattern matches."""
_GENERAL = frozenset(("node", "server", "robot", "ros", "ros2", "lifecycle", "nav2"))
"""Words that say nothing of what a node does."""


def may_be_called(launch: Launch, node: Started, name: str) -> bool:
    """Whether a node that the launch files do not name may get a name from its code."""
    package, program = text_of(node.package), text_of(node.executable or node.plugin)
    if node.name is not None or package is None or program is None:
        return True
    own = launch.workspace.packages.get(package)
    if own is not None:
        return name in code_of(launch, own.folder)
    words = [word for word in name.split("_") if len(word) > 2 and word not in _GENERAL]
    return not words or any(word in f"{package} {program}".lower() for word in words)


@kept
def all_names(launch: Launch) -> frozenset[str]:
    """The bare names of all nodes that any launch file of the tree starts."""
    return frozenset(_names(launch, launch.expansions))


def names_near(launch: Launch, file: LaunchFile) -> frozenset[str]:
    """The bare names of all nodes that the launch files of one robot or variant start."""
    near = (each for each in launch.expansions if launch.files.same_robot(each.entry.source, file.source))
    return frozenset(_names(launch, near))


def _names(launch: Launch, expansions: Iterable[Expansion]) -> Iterator[str]:
    for expansion in expansions:
        for node in expansion.nodes:
            name = full_name(node, launch.role(node))
            if name is not None:
                yield name.rpartition("/")[2]


@kept
def managed_names(launch: Launch) -> frozenset[str] | None:
    """The bare names of all nodes that any lifecycle manager of the tree lists; None when a list is not known."""
    found: set[str] = set()
    for expansion in launch.expansions:
        for manager in managers(expansion):
            if manager.managed is None:
                return None
            found.update(managed.fqn.rpartition("/")[2] for managed in manager.managed)
    return frozenset(found)


def switched_by_program(launch: Launch, name: str) -> bool:
    """Whether a program of the tree that changes the states of nodes names this one."""
    word = re.compile(rf"\b{re.escape(name)}\b")
    return any(word.search(text) for text in _switching(launch) if name in text)


def is_switched(launch: Launch) -> bool:
    """Whether some program of the tree changes the states of nodes."""
    return bool(_switching(launch))


@kept
def _switching(launch: Launch) -> list[str]:
    """The texts of the programs that change the states of nodes."""
    texts = (source.said for source in launch.files.of_kind(*_PROGRAMS))
    return [text for text in texts if any(word in text for word in _SWITCH_WORDS) and _SWITCHES.search(text)]


def as_lifecycle_node(launch: Launch, node: Started) -> Span | None:
    """Where a launch file of the tree starts the program of a node as a ``LifecycleNode``."""
    return _lifecycle_programs(launch).get((literal_text(node.package), literal_text(node.executable)))


@kept
def _lifecycle_programs(launch: Launch) -> dict[tuple[str | None, str | None], Span]:
    """Package and executable -> the first place; both have to be known."""
    found: dict[tuple[str | None, str | None], Span] = {}
    for node in launch.nodes:
        program = literal_text(node.package), literal_text(node.executable)
        if getattr(node.action, "lifecycle", False) and None not in program:
            found.setdefault(program, node.span)
    return found


def is_plain(launch: Launch, node: Started) -> bool:
    """Whether the C++ package of a node, which is in the tree, builds on nothing of the lifecycle."""
    package = launch.workspace.packages.get(literal_text(node.package) or "")
    if package is None or package.manifest.build_type != "ament_cmake":
        return False
    texts = [package.manifest.source.text, *(build.source.text for build in package.builds)]
    return not any(_LIFECYCLE.search(text) for text in texts)
