"""The nodes that the files start: those that must run, those that may, and what the files do not tell."""

from __future__ import annotations

import shlex
from collections.abc import Callable
from collections.abc import Iterable
from collections.abc import Iterator
from typing import TYPE_CHECKING

from bringup_lint.dataclass import dataclass
from bringup_lint.dataclass import field
from bringup_lint.dataclass import replace
from bringup_lint.finding import Related
from bringup_lint.graph.commands.environment import Environment
from bringup_lint.graph.commands.ros_command import Ros
from bringup_lint.graph.launch.expansion import Expansion
from bringup_lint.graph.launch.lifecycle import full_name
from bringup_lint.graph.launch.started import Started
from bringup_lint.graph.launch.started import literal_text
from bringup_lint.graph.observed.tools import OPEN_ENDED
from bringup_lint.graph.observed.tools import PASSING
from bringup_lint.graph.observed.tools import is_on_screen
from bringup_lint.graph.purpose import Purpose
from bringup_lint.graph.purpose import by_names
from bringup_lint.graph.runners.launching import expansion_of
from bringup_lint.graph.topics.resolved.process_arguments import ros_arguments
from bringup_lint.model.launch import LaunchFile
from bringup_lint.model.launch import Timer
from bringup_lint.model.launch_values import Literal
from bringup_lint.model.launch_values import Value
from bringup_lint.named_tuple import NamedTuple
from bringup_lint.source import Located
from bringup_lint.source import Span

if TYPE_CHECKING:
    from bringup_lint.discover.tree import Tree
    from bringup_lint.graph.environment.ros import RosEnvironment
    from bringup_lint.graph.environment.ros import RosProcess
    from bringup_lint.graph.files import Files
    from bringup_lint.graph.launch.launch import Launch
    from bringup_lint.graph.nodes.nodes import Nodes
    from bringup_lint.graph.systemd.unit import Unit
    from bringup_lint.graph.systemd.units import Units
    from bringup_lint.graph.topics.topics import Topics

PROGRAMS = ("launch", "run", "node")
"""What starts nodes."""


class ExpectedNode(NamedTuple):
    name: str
    """Fully qualified."""
    where: Span
    must: bool
    """Whether it runs whenever its entry runs, for as long as that runs."""
    entry: Entry
    started: Started | None = None

    @property
    def package(self) -> str | None:
        return literal_text(self.started.package) if self.started else None

    @property
    def chain(self) -> list[Related]:
        """The places that lead to the node: what runs the launch file, and the includes."""
        steps = [Related(self.entry.where, f"{self.entry.who} starts it")] if self.entry.who else []
        if self.started:
            steps += [Related(span, "included here") for span in self.started.chain]
        return steps


@dataclass(eq=False)
class Entry:
    """Something that starts ROS 2 nodes: a command of a unit or service, or a launch file."""

    where: Span
    who: str
    """``robot.service``, ``service 'driver'``; empty for a launch file that nothing of the tree starts."""
    runs: bool
    """Whether it runs on a robot that has come up, unless another entry runs in its place."""
    group: str = ""
    """What comes up together: the units of one place, the services of one compose file."""
    unit: Unit | None = None
    environment: Environment | None = None

    @property
    def simulates(self) -> bool:
        """Whether its name says that it stands in for the robot, or for hardware."""
        return by_names([self.who.replace("'", "/"), self.where.path]) is not Purpose.ROBOT


@dataclass(eq=False)
class Expected:
    nodes: list[ExpectedNode] = field(default_factory=list)
    gaps: list[tuple[Span, str]] = field(default_factory=list)
    """Where what runs may start nodes whose names the files do not tell, and why not."""
    ambiguous: bool = False
    """Nothing tells which of several launch files runs."""

    @property
    def must(self) -> frozenset[str]:
        """The names of all nodes that run on a robot that has come up."""
        return frozenset(node.name for node in self.nodes if node.must)

    @property
    def entries(self) -> dict[Entry, list[ExpectedNode]]:
        """What runs on a robot that has come up, with the nodes that it must have started."""
        found: dict[Entry, list[ExpectedNode]] = {}
        for node in self.nodes:
            if node.must:
                found.setdefault(node.entry, []).append(node)
        return found

    def named(self, name: str) -> ExpectedNode | None:
        """The node of a name; one that must run before one that may."""
        found = [node for node in self.nodes if node.name == name]
        return next(iter(sorted(found, key=lambda node: not node.must)), None)


def launch_file(tree: Tree, launch: Launch, command: str) -> LaunchFile | None:
    """The launch file that ``[PACKAGE] FILE [NAME:=VALUE]...`` names. Raises ValueError for an open quote."""
    named = [word for word in shlex.split(command) if ":=" not in word]
    if len(named) == 1:
        path = tree.real_path(named[0])
        found = [file for file in launch.launch_files if tree.real_path(file.source.name) == path]
        return found[0] if found else launch.named(None, named[0])
    return launch.named(named[0], named[1]) if len(named) == 2 else None


@dataclass(frozen=True)
class Sources:
    """The layers that say which nodes the files start."""

    files: Files
    units: Callable[[], Units]
    ros: Callable[[], RosEnvironment]
    launch: Launch
    nodes: Callable[[], Nodes]
    topics: Topics

    def expected(self, commands: tuple[str, ...] = ()) -> Expected:
        """From ``commands``, what was launched; else what units and services start; else from the only launch file
        there is."""
        result = Expected()
        if commands:
            for command in commands:
                self._add_command(result, command)
        else:
            for entry, ros in self._programs(result):
                self._add_program(result, entry, ros)
        lists = [expansion for expansion in self.launch.entries if not self.launch.simulated(expansion.entry)]
        started_by_files = any(node.entry.runs for node in result.nodes)
        result.ambiguous = not started_by_files and not commands and len(lists) > 1
        gaps = list(result.gaps)
        for expansion in self.launch.entries:
            file = expansion.entry
            alone = not started_by_files and not gaps and not commands and lists == [expansion]
            self._add_nodes(result, Entry(file.entry or file.source.whole, "", alone), expansion)
        if started_by_files or commands:
            result.gaps = gaps
        return result

    def _add_command(self, result: Expected, command: str) -> None:
        """``[PACKAGE] FILE [NAME:=VALUE]...`` from the command line."""
        file = launch_file(self.files.tree, self.launch, command)
        if file is None:
            return
        passed = (word.partition(":=") for word in shlex.split(command) if ":=" in word)
        arguments: dict[str, Value] = {
            name: Literal(Located(value, file.source.whole), file.source.whole) for name, _, value in passed
        }
        expansion = self.launch.expand(file, arguments)
        self._add_nodes(result, Entry(file.entry or file.source.whole, "", True, command), expansion)

    def _programs(self, result: Expected) -> Iterator[tuple[Entry, Ros]]:
        """The ROS 2 programs that units and compose services start."""
        if self.files.of_kind("systemd-unit", "systemd-dropin"):
            yield from _of_units(result, self.units())
        if self.files.of_kind("compose"):
            for process in self.ros().launchers:
                yield from _of_service(result, process)

    def _add_program(self, result: Expected, entry: Entry, ros: Ros) -> None:
        if ros.kind == "launch":
            expansion = expansion_of(ros, self.launch)
            if expansion is None:
                result.gaps.append((entry.where, "this launch file is not in the tree"))
                return
            if entry.simulates or self.launch.simulated(expansion.entry):
                self._add_nodes(Expected(result.nodes), replace(entry, runs=False), expansion)
            else:
                self._add_nodes(result, entry, expansion)
            return
        name = _run_name(ros.arguments, self._own_name(ros))
        if name is None:
            result.gaps.append((entry.where, "the name of this node is not known here"))
        else:
            result.nodes.append(ExpectedNode(name, entry.where, entry.runs and not entry.simulates, entry))

    def _own_name(self, ros: Ros) -> str | None:
        """What a program of the tree calls its only node."""
        program = self.nodes().program(str(ros.package), str(ros.target)) if ros.kind == "run" else None
        if program is None or len(program.classes) != 1 or program.classes[0].namespace is not None:
            return None
        return program.classes[0].node_name

    def _add_nodes(self, result: Expected, entry: Entry, expansion: Expansion) -> None:
        if expansion.open:
            result.gaps.append((entry.where, "not everything that this leads to is in the tree"))
        ended = {handler.target for handler, _ in expansion.handlers if handler.event == "OnProcessExit"}
        for node in expansion.nodes:
            if not node.is_node:
                result.gaps.append((node.span, "this process may be a node"))
                continue
            name = self.topics.node(node).fqn or full_name(node, self.launch.role(node))
            if name is None or not ros_arguments(node).known:
                result.gaps.append((node.span, "the name of this node is not known here"))
                continue
            if literal_text(node.package) in OPEN_ENDED:
                result.gaps.append((node.span, "this node brings along others"))
            must = entry.runs and _certainly_stays(node, name) and node.action.key not in ended
            result.nodes.append(ExpectedNode(name, _place(node), must, entry, node))


def _of_units(result: Expected, units: Units) -> Iterator[tuple[Entry, Ros]]:
    for unit in units.ros:
        if not unit.judged or unit.masked or unit.get("Type") == "oneshot" or unit.name in units.triggered:
            continue
        runs = not unit.is_template and any(True for _ in units.wanted_by(unit))
        for process in units.started(unit):
            programs = [(step, ros) for step, ros in process.ros if ros.kind in PROGRAMS]
            for _, ros in programs:
                environment = units.environment(unit)
                yield Entry(ros.where.span, unit.name, runs, f"{unit.manager} {unit.place}", unit, environment), ros
            if process.mentions_ros and (process.opaque or not programs):
                result.gaps.append((unit.where, f"what {unit.name} starts is not known to the end"))


def _of_service(result: Expected, process: RosProcess) -> Iterator[tuple[Entry, Ros]]:
    service = process.service
    if service is None:
        return
    programs = [start.ros for start in process.starts if start.ros.kind in PROGRAMS]
    who, runs = f"service '{service.name}'", service.get("profiles") is None
    for ros in programs:
        yield Entry(ros.where.span, who, runs, service.source.name, environment=process.environment), ros
    if not programs:
        result.gaps.append((service.name.span, f"what {who} starts is not known"))


def _run_name(words: Iterable[Located], own: str | None) -> str | None:
    """The full name, as ``--ros-args -r __node:=x -r __ns:=/y`` changes it."""
    given = dict(word.split(":=", 1) for word in words if word.startswith(("__node:=", "__ns:=")))
    name, namespace = given.get("__node", own), given.get("__ns", "/")
    if name is None or "$" in name + namespace or not namespace.startswith("/"):
        return None
    return f"{namespace.rstrip('/')}/{name}"


def _certainly_stays(node: Started, name: str) -> bool:
    """Whether a node that its entry starts runs for as long as that does."""
    if node.by_default is not True or _loops(node) or _passes(node) or is_on_screen(name):
        return False
    return all(isinstance(action, Timer) for action in node.context)


def _passes(node: Started) -> bool:
    """Whether the program does its work and ends."""
    program = literal_text(node.executable)
    return program is not None and bool(PASSING.search(program))


def _place(node: Started) -> Span:
    """The name where it is written beside the node, else the node."""
    name = literal_text(node.name)
    source, start, end = node.span
    return name.span if name and name.span.source is source and start <= name.span.start < end else node.span


def _loops(node: Started) -> bool:
    return any(condition.kind == "loop" for condition in node.conditions)
