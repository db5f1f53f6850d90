"""The environment that systemd gives to the processes of a unit.

systemd.exec(5), "Environment": PassEnvironment=, then Environment=, then EnvironmentFile= (which wins), then
UnsetEnvironment=; a shell adds what it assigns and exports.
"""

from __future__ import annotations

import re
from typing import TYPE_CHECKING
from typing import NamedTuple

from bringup_lint.graph.commands.environment import SETUP_FILE
from bringup_lint.graph.commands.environment import Environment
from bringup_lint.graph.commands.environment import Variable
from bringup_lint.graph.commands.environment import after_commands
from bringup_lint.graph.commands.environment import assign_before
from bringup_lint.graph.systemd.unit import Unit
from bringup_lint.parsers.systemd_values import expand
from bringup_lint.parsers.systemd_values import split_environment
from bringup_lint.parsers.systemd_values import split_words
from bringup_lint.parsers.systemd_values import unit_specifiers
from bringup_lint.source import Located
from bringup_lint.source import Source

if TYPE_CHECKING:
    from bringup_lint.graph.commands.command_line import Step
    from bringup_lint.graph.systemd.process import Process
    from bringup_lint.robot import Robot

_GLOB = re.compile(r"[*?\[]")


class EnvironmentFile(NamedTuple):
    """One ``EnvironmentFile=`` of a unit."""

    value: Located
    """The path as written, without the dash."""
    optional: bool
    path: str | None
    """The path on the robot; None when it holds a wildcard or a specifier that is not known."""
    source: Source | None
    """The file, when the tree holds it."""
    missing: bool | None
    """True: it is not there; None: the tree cannot tell."""


def environment_files(unit: Unit, robot: Robot) -> list[EnvironmentFile]:
    """The environment files of a unit, in the order in which they are read; resets count."""
    found = []
    for value in unit.values("EnvironmentFile", unit.section):
        optional = value.startswith("-")
        name = value.part(1, len(value)) if optional else value
        path = None if unit.is_opaque(value) or _GLOB.search(name) else expand(name, unit_specifiers(unit.name))
        source = robot.find(path, value.span.source) if path else None
        there = True if source else robot.tree.has(path) if path else None
        found.append(EnvironmentFile(name, optional, path, source, None if there is None else not there))
    return found


def unit_environment(unit: Unit, robot: Robot) -> Environment:
    """What systemd gives to the processes of a unit."""
    environment = Environment(complete=not unit.unsure_of() and not unit.has("PAMName"))
    for value in unit.values("PassEnvironment", unit.section):
        for word in split_words(value).words:
            environment.set(Variable(str(word), word, None, "PassEnvironment="))
    known = unit_specifiers(unit.name)
    for value in unit.values("Environment", unit.section):
        opaque = unit.is_opaque(value)
        environment.complete &= not opaque
        for name, word in split_environment(value):
            environment.set(Variable(str(name), word, None if opaque else expand(word, known), "Environment="))
    for file in environment_files(unit, robot):
        _read(environment, file, robot)
    for value in unit.values("UnsetEnvironment", unit.section):
        for word in split_words(value).words:
            environment.unset(word.partition("=")[0])
    return environment


def _read(environment: Environment, file: EnvironmentFile, robot: Robot) -> None:
    if file.source is None:
        environment.complete &= file.missing is True
        return
    model = robot.environment_file(file.path)
    for entry in model.entries if model else ():
        text = None if file.source.template else str(entry.value)
        environment.set(Variable(str(entry.name), entry.value, text, "EnvironmentFile="))
    environment.complete &= not file.source.template


def process_environment(process: Process, robot: Robot, until: Step | None = None) -> Environment:
    """The environment of a command line of a unit, or of one step of what its shells and scripts run."""
    steps = process.steps[: process.steps.index(until)] if until else process.steps
    commands = [step.command for step in steps]
    found = after_commands(
        robot.units.environment(process.unit),
        commands,
        lambda path: bool(SETUP_FILE.search(path)) or robot.tree.find(path) is not None,
    )
    if until is not None:
        assign_before(found, until.command)
    return found
