"""The Python sources of nodes in the tree, joined with the packages and launch files that start them."""

from __future__ import annotations

import os
import re
from collections.abc import Iterator
from functools import cached_property
from typing import TYPE_CHECKING

from bringup_lint.graph.launch.started import Started
from bringup_lint.graph.launch.started import literal_text
from bringup_lint.graph.nodes.modules import Modules
from bringup_lint.graph.nodes.programs import Program
from bringup_lint.graph.nodes.programs import program_of
from bringup_lint.model.node_source import NodeClass
from bringup_lint.model.node_source import NodeSource
from bringup_lint.parsers.python_node import parse
from bringup_lint.source import Source

if TYPE_CHECKING:
    from bringup_lint.robot import Robot

_TEST = re.compile(r"(?:^|[/_-])tests?(?:[/_.-]|$)|(?:^|/)(?:testing|integration_tests?)/", re.I)
_EXAMPLE = re.compile(r"(?:^|[/_-])(?:examples?|demos?|tutorials?|samples?)(?:[/_.-]|$)|(?:^|/)docs?/", re.I)


class Nodes:
    """``sources``: every Python node source of the tree, read."""

    def __init__(self, robot: Robot) -> None:
        self.robot = robot
        self.sources: list[NodeSource] = robot.parsed(parse, robot.of_kind("python-node"))
        self._modules = Modules(robot, self.sources)
        self._modules.link()

    @cached_property
    def judged(self) -> list[NodeSource]:
        """Those that findings may be about."""
        return [file for file in self.sources if file.source.judged and file.tree is not None]

    def __iter__(self) -> Iterator[NodeSource]:
        return iter(self.judged)

    @property
    def classes(self) -> Iterator[NodeClass]:
        """The classes of nodes, and the nodes without one, of the judged sources."""
        for file in self.judged:
            yield from (each for each in file.classes if each.is_node is True)

    def file_of(self, node: NodeClass) -> NodeSource:
        return self._modules.by_source[id(node.source)]

    def purpose(self, source: Source) -> str:
        """``test``, ``example`` or an empty string, by the path of the file in its package."""
        if id(source) not in self._purposes:
            path = self._path(source)
            self._purposes[id(source)] = "test" if _TEST.search(path) else "example" if _EXAMPLE.search(path) else ""
        return self._purposes[id(source)]

    @cached_property
    def _purposes(self) -> dict[int, str]:
        return {}

    def _path(self, source: Source) -> str:
        """The path from the folder of the package on; the last two components when that is not known."""
        owner = self.robot.launch.workspace.owner(source)
        path = os.path.abspath(source.name)
        if owner is not None:
            return os.path.relpath(path, os.path.dirname(owner.folder))
        return "/".join(path.split("/")[-2:]) if os.path.isabs(source.name) else source.name

    def program(self, package: str, executable: str) -> Program | None:
        """The source of ``ros2 run package executable``; None when it is not Python, or not in the tree."""
        key = (package, executable)
        if key not in self._programs:
            self._programs[key] = program_of(self.robot, self._modules, package, executable)
        return self._programs[key]

    @cached_property
    def _programs(self) -> dict[tuple[str, str], Program | None]:
        return {}

    def program_of(self, started: Started) -> Program | None:
        """The source of what a launch file or command starts."""
        package, executable = literal_text(started.package), literal_text(started.executable)
        return self.program(str(package), str(executable)) if package and executable else None

    def of(self, started: Started) -> NodeClass | None:
        """The class of the one node that a launched program makes; None when it makes several, or that is not known."""
        program = self.program_of(started)
        return program.classes[0] if program is not None and len(program.classes) == 1 else None

    @cached_property
    def _starters(self) -> dict[int, list[Started]]:
        found: dict[int, list[Started]] = {}
        for started in self.robot.launch.nodes:
            program = self.program_of(started)
            for node in program.classes if program is not None else ():
                found.setdefault(id(node), []).append(started)
        return found

    def started(self, node: NodeClass) -> list[Started]:
        """The launch actions that start a node of this class, each as its own file starts it."""
        return self._starters.get(id(node), [])


def load_nodes(robot: Robot) -> Nodes:
    return Nodes(robot)
