"""The Python sources of nodes in the tree, joined with the packages and launch files that start them."""

from __future__ import annotations

import ast
import os
import re
from collections.abc import Callable
from collections.abc import Iterator
from functools import cached_property
from itertools import islice
from typing import TYPE_CHECKING

from bringup_lint.dataclass import dataclass
from bringup_lint.discover.kinds.launch import LAUNCH
from bringup_lint.finding import Related
from bringup_lint.graph.launch.started import Started
from bringup_lint.graph.launch.started import literal_text
from bringup_lint.graph.memo import memo
from bringup_lint.graph.nodes.resolved.programs import Program
from bringup_lint.graph.nodes.resolved.programs import made
from bringup_lint.graph.nodes.resolved.programs import program_of
from bringup_lint.graph.nodes.sources.ending import Ending
from bringup_lint.graph.nodes.sources.modules import Modules
from bringup_lint.graph.nodes.sources.syntax import Syntax
from bringup_lint.graph.nodes.sources.threads import ends_thread
from bringup_lint.graph.nodes.sources.threads import is_joined_elsewhere
from bringup_lint.graph.nodes.unused import Unused
from bringup_lint.graph.purpose import Purpose
from bringup_lint.graph.purpose import of_source
from bringup_lint.graph.runners.runner import SUPERVISING
from bringup_lint.graph.runners.runner import RunnerKind
from bringup_lint.model.node_source import NodeClass
from bringup_lint.model.node_source import NodeSource
from bringup_lint.model.python import is_self
from bringup_lint.parsers.python_node import parse
from bringup_lint.parsers.python_node.classes import ROOTS
from bringup_lint.pattern import regex
from bringup_lint.source import Source

if TYPE_CHECKING:
    from bringup_lint.graph.files import Files
    from bringup_lint.graph.launch.launch import Launch
    from bringup_lint.graph.nodes.sources.message_types import MessageTypes
    from bringup_lint.graph.provenance import Provenance
    from bringup_lint.graph.runners.runner import Runner
    from bringup_lint.graph.runners.runners import Runners
    from bringup_lint.graph.workspace import Package
    from bringup_lint.model.cpp_driver import CppDriver
    from bringup_lint.model.cpp_source import CppNode
    from bringup_lint.model.cpp_source import LateJoin
    from bringup_lint.model.launch import Action
    from bringup_lint.model.launch import LaunchFile

_TIMERS = regex(r"\bcreate_(?:timer|rate|wall_timer)\b|\bTimer\(|\bcreate_task\b", hints="create_ Timer(")
_GATES = regex(
    r"\b(?:cmd_vel_timeout|reference_timeout|diff_drive_controller|mecanum_drive_controller|ackermann_steering_controller"
    r"|tricycle_controller|twist_mux|velocity_smoother|collision_monitor|create3)\b",
    hints="cmd_vel_timeout reference_timeout _controller twist_mux velocity_smoother collision_monitor create3",
)
"""Parameters, controllers and filters that end a motion when no command comes."""
FIRMWARE = 100
"""Files of firmware that are looked at."""
_FIRMWARE = (".ino", "/src/main.cpp", "/main.c")
_MILLIS = regex(r"\bmillis\s{0,2}\(\)\s{0,4}-|\btime_?out|\bwatch_?dog|HAL_GetTick\s{0,2}\(\)\s{0,4}-", re.I)
_SERVO = regex(r"(?m)^[ \t]*incoming_command_timeout[ \t]*:[ \t]*(?!0+(?:\.0*)?[ \t]*(?:#|$))[\d.]")
_SERVO_TOPIC = regex(
    r"(?m)^[ \t]*(?:cartesian|joint)_command_in_topic[ \t]*:[ \t]*[\"']?(?:[^\s\"'#]*/)?(?P<name>[^\s\"'#/]+)"
)
"""MoveIt Servo halts when the newest command on these topics is older than the time-out."""
_RUNNING = (ast.FunctionDef, ast.AsyncFunctionDef, ast.If, ast.Try, ast.For, ast.While, ast.With)
"""Statements of a module that run, or that others may call."""
_UNJUDGED = (Purpose.TEST, Purpose.CI, Purpose.ARCHIVE)
"""Purposes whose sources are not for a robot."""
_TOOL = regex(
    r"(?:^|_)(?:calibrat\w*?|capture|gathering|gui|dummy|evaluat(?:e|or|ion)|visuali[sz](?:e|er|ation)|plot(?:ter)?"
    r"|debug(?:ger)?|bt_(?:monitor|viewer))(?=[_.]|$)|^check_",
    re.I,
)
"""Names of programs for people: they look at the robot, set it up or stand in for a part of it."""


@dataclass(eq=False)
class Nodes:
    files: Files
    launch: Launch
    _runners: Callable[[], Runners]
    _provenance: Callable[[], Provenance]

    @cached_property
    def sources(self) -> list[NodeSource]:
        """Every Python node source of the tree, its classes linked to those that they build on."""
        return self._modules.files

    @cached_property
    def _modules(self) -> Modules:
        found = self.files.parsed(parse, self.files.of_kind("python-node"))
        modules = Modules(self.files.tree, self.launch.workspace, found, self.files.parsed)
        modules.link()
        return modules

    def let_go(self) -> None:
        """Forget the syntax that belongs to this run alone."""
        if "_modules" in self.__dict__:
            self._modules.let_go()

    @cached_property
    def judged(self) -> list[NodeSource]:
        """Those that findings may be about."""
        return [file for file in self.sources if file.source.judged and file.tree is not None]

    @cached_property
    def with_modules(self) -> list[NodeSource]:
        """Those, and the files of the tree that they import, also through each other, in the order of imports."""
        return self._reached(self.judged)

    def _reached(self, files: list[NodeSource]) -> list[NodeSource]:
        """Files, and those of the tree that they import, also through each other."""
        found = {file.source: file for file in files}
        todo = list(reversed(files))
        while todo:
            new = (each for each in self._modules.imported(todo.pop()) if each.source not in found)
            for file in new:
                found[file.source] = file
                todo.append(file)
        return list(found.values())

    def importers(self, source: Source) -> list[NodeSource]:
        """The files with classes of nodes that import a file, by themselves or through others."""
        return self._importers.get(source, [])

    @cached_property
    def _importers(self) -> dict[Source, list[NodeSource]]:
        found: dict[Source, list[NodeSource]] = {}
        for file in self.judged:
            if any(each.is_node is True for each in file.classes):
                for module in self._reached([file]):
                    if module is not file:
                        found.setdefault(module.source, []).append(file)
        return found

    def __iter__(self) -> Iterator[NodeSource]:
        return iter(self.judged)

    @cached_property
    def cpp(self) -> list[CppNode]:
        """The judged C++ sources of nodes but tests, those that hold a construct of rclcpp."""
        if not self.files.of_kind("cpp-node"):
            return []
        from bringup_lint.parsers.cpp_node import parse as parse_cpp

        sources = (each for each in self.files.of_kind("cpp-node") if each.judged and not each.template)
        programs = [each for each in sources if self.purpose(each) not in _UNJUDGED]
        return self.files.parsed(parse_cpp, programs)

    @cached_property
    def drivers(self) -> list[CppDriver]:
        """The judged C++ sources, of nodes or not, but tests: what they do with the answers of devices."""
        sources = [each for each in self.files.of_kind("cpp-node", "cpp-driver") if each.judged and not each.template]
        if not sources:
            return []
        from bringup_lint.parsers.cpp_driver import parse as parse_driver

        return self.files.parsed(parse_driver, (each for each in sources if self.purpose(each) not in _UNJUDGED))

    def named_alike(self, source: Source) -> list[Source]:
        """The C++ sources of the package of one that have its name up to the first dot, as its header has."""
        return self._by_stem.get(self._stem(source), [])

    def headers(self, source: Source) -> list[CppNode]:
        """The other C++ sources of the package of one that have its name up to the first dot."""
        from bringup_lint.parsers.cpp_node import parse as parse_cpp

        return self.files.parsed(parse_cpp, (each for each in self.named_alike(source) if each is not source))

    @cached_property
    def _by_stem(self) -> dict[tuple[Package | None, str], list[Source]]:
        found: dict[tuple[Package | None, str], list[Source]] = {}
        for source in self.files.of_kind("cpp-node", "cpp-driver"):
            found.setdefault(self._stem(source), []).append(source)
        return found

    def _stem(self, source: Source) -> tuple[Package | None, str]:
        return self.launch.workspace.owner(source), source.basename.partition(".")[0]

    def ends_thread(self, source: Source, name: str) -> bool:
        """Whether the package of a C++ source joins or detaches a thread."""
        return ends_thread(self.files, self.launch.workspace.owner(source), source, name)

    def late_join(self, source: CppNode, name: str) -> LateJoin | None:
        """The joins of a thread in callbacks, where nothing else of the package ends it."""
        found = next((each for each in source.late_joins if each.thread == name), None)
        owner = self.launch.workspace.owner(source.source)
        is_else = found is not None and is_joined_elsewhere(self.files, owner, source.source, found)
        return None if is_else else found

    @property
    def classes(self) -> Iterator[NodeClass]:
        """The classes of nodes, and the nodes without one, of the judged sources."""
        for file in self.judged:
            yield from (each for each in file.classes if each.is_node is True)

    def file_of(self, node: NodeClass) -> NodeSource:
        return self._modules.by_source[node.source]

    @memo
    def purpose(self, source: Source) -> Purpose:
        """What a source is for, by the path of the file and by that in its package."""
        found = of_source(self._path(source), self.files.purpose(source))
        is_example = found is Purpose.ROBOT and (self._unused.has(source) or self._is_unmade(source))
        return Purpose.EXAMPLE if is_example else found

    def _is_unmade(self, source: Source) -> bool:
        """Whether a file is no program and holds classes alone, and nothing makes one of them."""
        file = self._modules.by_source.get(source)
        body = file.tree.body if file is not None and file.tree is not None else []
        classes = [each.name for each in body if isinstance(each, ast.ClassDef)]
        if not classes or not self._unused.is_no_program(source) or any(isinstance(each, _RUNNING) for each in body):
            return False
        return not any(map(self._unused.makes, classes))

    def graded(self, source: Source, severity: str) -> str:
        """The severity of a finding in a source: less in an example, and in what others wrote, as its package or a
        folder of it says."""
        is_vendored = self.launch.workspace.is_vendored(source)
        return severity if self.is_for_robot(source) and not is_vendored else "info"

    @cached_property
    def _unused(self) -> Unused:
        return Unused(self.files, self.launch.workspace)

    def runs_main(self, source: Source) -> bool:
        """Whether something may start a file as a program, rather than only import it."""
        return not self._unused.is_no_program(source)

    def is_for_robot(self, source: Source) -> bool:
        return self.purpose(source) is Purpose.ROBOT

    def _path(self, source: Source) -> str:
        """The path from the folder of the package on; the last two components when that is not known."""
        owner = self.launch.workspace.owner(source)
        path = source.absolute
        if owner is not None:
            return os.path.relpath(path, os.path.dirname(owner.folder))
        return "/".join(path.split("/")[-2:]) if os.path.isabs(source.name) else source.name

    def program(self, package: str, executable: str) -> Program | None:
        """The source of ``ros2 run package executable``; None when it is not Python, or not in the tree."""
        key = (package, executable)
        if key not in self._programs:
            self._programs[key] = program_of(self.launch.workspace, self._modules, package, executable)
        return self._programs[key]

    @cached_property
    def _programs(self) -> dict[tuple[str, str], Program | None]:
        return {}

    def program_of(self, started: Started) -> Program | None:
        """The source of what a launch file or command starts."""
        package, executable = literal_text(started.package), literal_text(started.executable)
        return self.program(str(package), str(executable)) if package and executable else None

    @cached_property
    def _starters(self) -> dict[NodeClass, list[Started]]:
        found: dict[NodeClass, list[Started]] = {}
        for started, program in self._launched_programs:
            for node in program.classes:
                found.setdefault(node, []).append(started)
        return found

    @cached_property
    def _by_file(self) -> dict[Source, list[Started]]:
        found: dict[Source, list[Started]] = {}
        for started, program in self._launched_programs:
            found.setdefault(program.file.source, []).append(started)
        return found

    @cached_property
    def _launched_programs(self) -> list[tuple[Started, Program]]:
        """The programs of the tree that launch files start, each with the action that does."""
        found = ((started, self.program_of(started)) for started in self.launch.nodes)
        return [(started, program) for started, program in found if program is not None]

    def launched(self, file: NodeSource) -> list[Started]:
        """The launch actions that run a file as a program."""
        return self._by_file.get(file.source, [])

    def runners(self, file: NodeSource) -> list[Runner]:
        """Those whose launch files run a file as a program; people, who run scripts, are left out."""
        actions = {started.action for started in self.launched(file)}
        if not actions:
            return []
        launches = (each for each in self._runners().launches if each.runner.kind is not RunnerKind.SCRIPT)
        files = ((each.runner, each.file) for each in launches if each.file is not None)
        return list(dict.fromkeys(runner for runner, launched in files if actions & self._actions(launched)))

    def is_supervised(self, file: NodeSource) -> bool:
        """Whether a runner that is not a person runs a file as a program, by itself or through a launch file."""
        if file.source in self._run_directly or self.runners(file):
            return True
        return file.source.basename in self._runner_texts

    @cached_property
    def _runner_texts(self) -> str:
        """What starts processes, in one text, which is searched sooner than many."""
        return "\0".join(each.text for each in self.files.of_kind(*SUPERVISING))

    def is_stopped(self, file: NodeSource) -> bool:
        """Whether a unit, a container or the like starts a program that is not for tests, examples or a person, and so
        stops it with a signal; a launch file alone is stopped by a person at the keyboard."""
        if not self.is_supervised(file) or not self.is_for_robot(file.source):
            return False
        return not self.is_tool(file) and not self.launch.workspace.is_vendored(file.source)

    def is_tool(self, file: NodeSource) -> bool:
        """Whether a person runs a program to look at the robot or to set it up, or one for a simulator."""
        ending = self.ending(file)
        return ending.reads_keys or ending.drives_simulator or bool(_TOOL.search(file.source.basename))

    @cached_property
    def _run_directly(self) -> frozenset[Source]:
        """The files that ``ros2 run`` starts for a unit, a container or the like."""
        found: set[Source] = set()
        for runner in self._runners().all:
            if runner.kind is RunnerKind.SCRIPT:
                continue
            named = (each.ros for each in runner.starts if each.ros.package and each.ros.target)
            programs = (self.program(str(ros.package), str(ros.target)) for ros in named)
            found |= {program.file.source for program in programs if program is not None}
        return frozenset(found)

    @memo
    def _actions(self, file: LaunchFile) -> set[Action]:
        """The actions of all nodes that a launch file starts."""
        return {node.action for node in self.launch.expansion(file).nodes}

    def stopped_by(self, file: NodeSource) -> set[str]:
        """The signals with which runners stop a file that they start; empty when none does, or that is not known."""
        signals = {runner.stop.signal for runner in self.runners(file)}
        return {signal for signal in signals if signal is not None} if None not in signals else set()

    def chain_to(self, file: NodeSource, *more: Related) -> tuple[Related, ...]:
        """How a runner and launch files lead to a file; empty when none does."""
        chains = (self._provenance().chain_to_node(each, *more) for each in self.launched(file))
        return next(filter(None, chains), ())

    def module_named(self, dotted: str, file: NodeSource) -> NodeSource | None:
        """The file of the tree that a module is for the imports of another file."""
        return self._modules.module(dotted, file)

    def imported(self, file: NodeSource) -> list[NodeSource] | None:
        """A file and all of the workspace that it imports; None when part of that is not found."""
        return self._modules.closure(file)

    @memo
    def made(self, file: NodeSource) -> list[NodeClass]:
        """The nodes that the code of a file makes, also of classes of other files."""
        return list(dict.fromkeys(made(self._modules, file, None)))

    def makers(self, node: NodeClass) -> list[NodeSource]:
        """The files of the tree that make a node of this class."""
        return self._makers.get(node, [])

    @cached_property
    def _makers(self) -> dict[NodeClass, list[NodeSource]]:
        found: dict[NodeClass, list[NodeSource]] = {}
        for file in self.sources:
            if file.tree is None:
                continue
            for node in self.made(file):
                found.setdefault(node, []).append(file)
        return found

    @cached_property
    def programs(self) -> list[NodeSource]:
        """The judged sources but tests: those whose ends are looked at."""
        return [file for file in self.judged if self.purpose(file.source) not in _UNJUDGED]

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
        roles = (self.launch.role(started).role for started in self.launch.nodes)
        if any(role in ("velocity filter", "safety") for role in roles):
            return "a velocity filter"
        found = (_GATES.search(source.text) for source in self.files.of_kind("params", *LAUNCH))
        return next((match[0] for match in found if match is not None), None)

    @cached_property
    def timed_topics(self) -> set[str]:
        """The last parts of the topics whose receiver MoveIt Servo halts when no command comes."""
        texts = [source.text for source in (*self.files.of_kind("params"), *self._servo_settings())]
        timed = (text for text in texts if _SERVO.search(text))
        return {match["name"] for text in timed for match in _SERVO_TOPIC.finditer(text)}

    @cached_property
    def firmware_looks_at_time(self) -> bool:
        """Whether firmware of the tree compares times, and so may stop motors for which no command comes."""
        paths = islice(self._firmware, FIRMWARE)
        sources = (self.files.tree.read(path, "cpp-node", judged=False) for path in paths)
        return any(source is not None and source.matches(_MILLIS) for source in sources)

    @property
    def has_firmware(self) -> bool:
        """Whether the tree holds firmware, so that what is not in it is known."""
        return next(self._firmware, None) is not None

    @property
    def _firmware(self) -> Iterator[str]:
        return (path for path in self.files.tree.paths if path.endswith(_FIRMWARE))

    def _servo_settings(self) -> Iterator[Source]:
        """MoveIt's own setting files hold no ``ros__parameters``: its launch files hand them over as dictionaries."""
        for path in self.files.tree.paths:
            if "servo" in path.rpartition("/")[2] and path.endswith((".yaml", ".yml")):
                source = self.files.tree.read(path, "params", judged=False)
                if source is not None:
                    yield source

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

    @cached_property
    def message_types(self) -> list[MessageTypes]:
        """The types of the expressions of each program that imports messages."""
        from bringup_lint.graph.nodes.resolved.interface_fields import InterfaceFields
        from bringup_lint.graph.nodes.sources.message_types import types_of

        interfaces = InterfaceFields(self.files.tree, self.launch.workspace)
        found = (types_of(file, self.syntax(file), interfaces) for file in self.programs)
        return [types for types in found if types is not None]

    @cached_property
    def set_elsewhere(self) -> set[str]:
        """Attributes that code of the tree sets on something else than ``self``."""
        attributes = (each for file in self.sources for each in file.nodes if isinstance(each, ast.Attribute))
        return {each.attr for each in attributes if isinstance(each.ctx, ast.Store) and not is_self(each.value)}

    def syntax(self, file: NodeSource) -> Syntax:
        return self.ending(file).syntax

    @memo
    def ending(self, file: NodeSource) -> Ending:
        """How the programs of a file end."""
        syntax = file.source.kept((Syntax, file), lambda: Syntax(file)) if file.is_alone else Syntax(file)
        syntax.reached.clear()
        return Ending(syntax, self.files.target.ros)

    def started(self, node: NodeClass) -> list[Started]:
        """The launch actions that start a node of this class, each as its own file starts it."""
        return self._starters.get(node, [])
