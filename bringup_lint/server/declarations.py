"""What is not a node of the graph, but declared somewhere: parameters and executables."""

from __future__ import annotations

import os
from collections.abc import Iterable
from collections.abc import Iterator

from bringup_lint.graph.launch.started import Started
from bringup_lint.graph.launch.started import literal_text
from bringup_lint.graph.nodes.resolved.programs import Program
from bringup_lint.graph.params.declared_types import declarations
from bringup_lint.graph.workspace import Package
from bringup_lint.model.launch_values import DictValue
from bringup_lint.model.params import Parameter
from bringup_lint.model.params import ParameterFile
from bringup_lint.pattern import regex
from bringup_lint.robot import Robot
from bringup_lint.source import Located
from bringup_lint.source import Source
from bringup_lint.source import Span

_CALL = regex(
    r"\b(?P<verb>declare|get|has|set)_parameter(?:_or|_if_not_declared)?\s*(?:<[^()<>]{0,80}(?:<[^()<>]{0,80}>)?\s*>\s*)?"
    r"\(\s*[\"'](?P<name>[\w./-]+)[\"']"
)
"""A call of rclcpp or rclpy in one line, with the literal name of a parameter."""


def declarations_at(robot: Robot, source: Source, offset: int) -> list[Span]:
    """Where the executable, package, component or parameter is declared that a place names.

    The name of a parameter in its own declaration leads to the values that parameter files give it.
    """
    return list(_found(robot, source, offset))


def _found(robot: Robot, source: Source, offset: int) -> Iterator[Span]:
    for started in robot.launch.nodes:
        yield from _of_started(robot, started, source, offset)
    for file in robot.params.parameter_files:
        if file.source is source:
            yield from _of_key(robot, file, offset)
    yield from _of_call(robot, source, offset)


def _holds(place: Located | None, source: Source, offset: int) -> bool:
    return place is not None and place.span.source is source and place.span.start <= offset <= place.span.end


def _of_started(robot: Robot, started: Started, source: Source, offset: int) -> Iterator[Span]:
    name, executable = literal_text(started.package), literal_text(started.executable)
    package = robot.launch.workspace.packages.get(name or "")
    if package is None:
        return
    if _holds(name, source, offset):
        yield _span(package.place)
    if executable is not None and _holds(executable, source, offset):
        yield from _of_executable(robot, package, executable)
    plugin = literal_text(started.plugin)
    if _holds(plugin, source, offset):
        yield from (each.span for each in package.plugins if each == plugin)
    for key in _keys(started):
        if _holds(key, source, offset):
            yield from _declared(robot, package.name, key)


def _keys(started: Started) -> Iterator[Located]:
    """The names of parameters that are written beside a node."""
    for value in started.parameters:
        if isinstance(value, DictValue):
            yield from (key for name, _ in value.items if (key := literal_text(name)) is not None)


def _of_executable(robot: Robot, package: Package, executable: Located) -> Iterator[Span]:
    """The source of a program, then the line that installs it."""
    program = robot.nodes.program(package.name, str(executable))
    if program is not None:
        yield _start_of(program)
    for source in _targets(robot, package, executable):
        yield source.span(0, 0)
    if executable in package.executables:
        yield package.executables[executable].span


def _start_of(program: Program) -> Span:
    called = program.file.functions.get(program.function or "")
    return called.name.span if called else program.file.source.span(0, 0)


def _targets(robot: Robot, package: Package, executable: str) -> Iterator[Source]:
    """The first source file of a target of CMake."""
    for build in package.builds:
        for name in build.targets.get(executable, ())[:1]:
            path = os.path.normpath(os.path.join(os.path.dirname(os.path.abspath(build.source.name)), name))
            source = robot.tree.read(path, judged=False) if path in robot.tree.paths else None
            if source is not None:
                yield source


def _of_key(robot: Robot, file: ParameterFile, offset: int) -> Iterator[Span]:
    for parameter in file.parameters:
        if _holds(parameter.key, file.source, offset):
            for package in _readers(robot, file, parameter):
                yield from _declared(robot, package, parameter.name)


def _readers(robot: Robot, file: ParameterFile, parameter: Parameter) -> Iterable[str]:
    """The packages of the nodes that a value reaches."""
    packages = (literal_text(load.node.package) for load in robot.params.effective(file, parameter))
    return dict.fromkeys(str(package) for package in packages if package)


def _declared(robot: Robot, package: str, name: str) -> Iterator[Span]:
    yield from (each.place.span for each in declarations(robot.params, package) if each.place == name)


def _of_call(robot: Robot, source: Source, offset: int) -> Iterator[Span]:
    owner = robot.launch.workspace.owner(source)
    start = source.text.rfind("\n", 0, offset) + 1
    end = source.text.find("\n", offset)
    for call in _CALL.finditer(source.text, start, len(source.text) if end < 0 else end):
        if owner is None or not call.start("name") <= offset <= call.end("name"):
            continue
        if call["verb"] == "declare":
            yield from _values(robot, owner, call["name"])
        else:
            yield from _declared(robot, owner.name, call["name"])


def _values(robot: Robot, package: Package, name: str) -> Iterator[Span]:
    for file in robot.params.parameter_files:
        for parameter in file.parameters:
            if parameter.name == name and package.name in _readers(robot, file, parameter):
                yield parameter.key.span


def _span(place: Located | Source) -> Span:
    return place.span if isinstance(place, Located) else place.span(0, 0)
