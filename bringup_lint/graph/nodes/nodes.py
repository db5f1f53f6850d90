"""The Python sources of nodes in the tree, joined with the packages and launch files that start them."""

from __future__ import annotations

import os
import re
from collections.abc import Iterator
from functools import cached_property
from typing import TYPE_CHECKING

from bringup_lint.finding import Related
from bringup_lint.graph.launch.started import Started
from bringup_lint.graph.launch.started import literal_text
from bringup_lint.graph.nodes.resolved.programs import Program
from bringup_lint.graph.nodes.resolved.programs import made
from bringup_lint.graph.nodes.resolved.programs import program_of
from bringup_lint.graph.nodes.sources.ending import Ending
from bringup_lint.graph.nodes.sources.modules import Modules
from bringup_lint.graph.nodes.sources.syntax import Syntax
from bringup_lint.model.node_source import NodeClass
from bringup_lint.model.node_source import NodeSource
from bringup_lint.parsers.python_node import parse
from bringup_lint.parsers.python_node.classes import ROOTS
from bringup_lint.source import Source

if TYPE_CHECKING:
    from bringup_lint.graph.systemd.unit import Unit
    from bringup_lint.robot import Robot

_TIMERS = re.compile(r"\bcreate_(?:timer|rate|wall_timer)\b|\bTimer\(|\bcreate_task\b")
_GATES = re.compile(
    r"\b(?:cmd_vel_timeout|reference_timeout|diff_drive_controller|mecanum_drive_controller|ackermann_steering_controller"
    r"|tricycle_controller|twist_mux|velocity_smoother|collision_monitor|create3)\b"
)
"""Parameters, controllers and filters that end a motion when no command comes."""
_STARTERS = (
    *("systemd-unit", "systemd-dropin", "compose", "dockerfile", "shell-script"),
    *("launch-python", "launch-xml", "launch-yaml", "env-file", "cmake", "setup-py"),
)
_TEST = re.compile(r"(?:^|[/_-])tests?(?:[/_.-]|$)|(?:^|/)(?:testing|integration_tests?)/", re.I)
_EXAMPLE = re.compile(
    r"(?:^|[/_-])(?:examples?|demos?|tutorials?|samples?)(?:[/_.-]|$)|(?:^|/)(?:docs?|tools?|benchmarks?)/", re.I
)
_SIMULATION = re.compile(r"(?:^|[/_-])(?:sim|simulation|simulator|gazebo|gz|mujoco|webots|isaac\w*)(?:[/_.-]|$)", re.I)
_PURPOSES = (("test", _TEST), ("example", _EXAMPLE), ("simulation", _SIMULATION))


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
        """``test``, ``example``, ``simulation`` or an empty string, by the path of the file in its package."""
        if id(source) not in self._purposes:
            path = self._path(source)
            self._purposes[id(source)] = next((name for name, words in _PURPOSES if words.search(path)), "")
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

    def by_hand(self, source: Source) -> bool:
        """Whether only people run a file: no package holds it, and nothing that starts things names it."""
        workspace = self.robot.launch.workspace
        if not workspace.packages or workspace.owner(source) is not None:
            return False
        return not any(source.basename in each.text for each in self.robot.of_kind(*_STARTERS))

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

    @cached_property
    def _programs_of(self) -> dict[int, list[Started]]:
        found: dict[int, list[Started]] = {}
        for started in self.robot.launch.nodes:
            program = self.program_of(started)
            if program is not None:
                found.setdefault(id(program.file.source), []).append(started)
        return found

    def launched(self, file: NodeSource) -> list[Started]:
        """The launch actions that run a file as a program."""
        return self._programs_of.get(id(file.source), [])

    def units(self, file: NodeSource) -> list[Unit]:
        """The units whose launch files run a file as a program."""
        actions = {id(started.action) for started in self.launched(file)}
        found: dict[int, Unit] = {}
        for command in self.robot.runners.launches if actions else ():
            unit = command.runner.unit
            if command.file is not None and unit is not None:
                nodes = self.robot.launch.expansion(command.file).nodes
                if any(id(node.action) in actions for node in nodes):
                    found[id(unit)] = unit
        return list(found.values())

    def made(self, file: NodeSource) -> list[NodeClass]:
        """The nodes that the code of a file makes, also of classes that stand in other files."""
        if id(file) not in self._made:
            self._made[id(file)] = list(dict.fromkeys(made(self._modules, file, None)))
        return self._made[id(file)]

    @cached_property
    def _made(self) -> dict[int, list[NodeClass]]:
        return {}

    def makers(self, node: NodeClass) -> list[NodeSource]:
        """The files of the tree that make a node of this class."""
        return self._makers.get(id(node), [])

    @cached_property
    def _makers(self) -> dict[int, list[NodeSource]]:
        found: dict[int, list[NodeSource]] = {}
        for file in self.sources:
            for node in self.made(file) if file.tree is not None else ():
                found.setdefault(id(node), []).append(file)
        return found

    @cached_property
    def programs(self) -> list[NodeSource]:
        """The judged sources but tests: those whose ends are looked at."""
        return [file for file in self.judged if self.purpose(file.source) != "test"]

    @property
    def with_callbacks(self) -> Iterator[tuple[NodeSource, NodeClass]]:
        """The classes of nodes in the judged sources but tests, each with its file."""
        for file in self.programs:
            yield from ((file, node) for node in file.classes if node.is_node is True)

    def threads(self, node: NodeClass) -> str:
        """Whether ``one`` thread runs the callbacks of a node or ``several``; empty when no file spins it."""
        texts = [file.source.text for file in (self.file_of(node), *self.makers(node))]
        if any("MultiThreadedExecutor" in text or "EventsExecutor" in text for text in texts):
            return "several"
        return "one" if any("spin" in text for text in texts) else ""

    @cached_property
    def gate(self) -> str | None:
        """Something of the tree that stops the robot by itself when commands fail to come, in a word."""
        roles = (self.robot.launch.role(started).role for started in self.robot.launch.nodes)
        if any(role in ("velocity filter", "safety") for role in roles):
            return "a velocity filter"
        kinds = ("params", "launch-python", "launch-xml", "launch-yaml")
        found = (_GATES.search(source.text) for source in self.robot.of_kind(*kinds))
        return next((match[0] for match in found if match is not None), None)

    def stopped_by(self, file: NodeSource) -> set[str]:
        """The signals with which units stop a file that they start; empty when no unit does, or that is not known."""
        services = [self.robot.units.supervision(unit) for unit in self.units(file)]
        signals = {str(service.kill_signal.value) for service in services}
        return signals if "None" not in signals else set()

    def way(self, file: NodeSource, *more: Related) -> tuple[Related, ...]:
        """How a unit and launch files lead to a file; empty when none does."""
        return next(
            filter(None, (self.robot.provenance.chain_to_node(each, *more) for each in self.launched(file))), ()
        )

    def without_timer(self, file: NodeSource) -> list[NodeClass]:
        """The nodes that a program makes, when surely none of them has a timer; else empty."""
        made = self.made(file)
        lineages = [each for node in made for each in node.lineage]
        known = all(each.is_node is True and self._is_followed(each) for each in lineages)
        texts = {each.source.text for each in lineages} | {file.source.text}
        if not known or any(_TIMERS.search(text) for text in texts):
            return []
        return made

    def _is_followed(self, node: NodeClass) -> bool:
        """Whether all that a class builds on is known."""
        return node.name is None or node.base is not None or all(base in ROOTS for base in node.bases)

    def syntax(self, file: NodeSource) -> Syntax:
        return self.ending(file).syntax

    def ending(self, file: NodeSource) -> Ending:
        """How the programs of a file end."""
        if id(file) not in self._endings:
            self._endings[id(file)] = Ending(Syntax(file), self.robot.target.ros)
        return self._endings[id(file)]

    @cached_property
    def _endings(self) -> dict[int, Ending]:
        return {}

    def started(self, node: NodeClass) -> list[Started]:
        """The launch actions that start a node of this class, each as its own file starts it."""
        return self._starters.get(id(node), [])


def load_nodes(robot: Robot) -> Nodes:
    return Nodes(robot)
