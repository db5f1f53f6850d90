"""The environment that systemd gives to the processes of a unit, and what their shells and scripts make of it.

systemd.exec(5), "Environment": PassEnvironment=, then Environment=, then EnvironmentFile= (which wins), then
UnsetEnvironment=.
"""

from __future__ import annotations

import posixpath

from bringup_lint.graph.commands.command_line import Step
from bringup_lint.graph.commands.environment import SETUP_FILE
from bringup_lint.graph.commands.environment import Environment
from bringup_lint.graph.commands.environment import Variable
from bringup_lint.graph.commands.environment import after_commands
from bringup_lint.graph.commands.environment import assign_before
from bringup_lint.graph.files import Files
from bringup_lint.graph.systemd.process import Process
from bringup_lint.graph.systemd.unit import Unit
from bringup_lint.named_tuple import NamedTuple
from bringup_lint.parsers.systemd_values import expand
from bringup_lint.parsers.systemd_values import split_environment
from bringup_lint.parsers.systemd_values import split_words
from bringup_lint.parsers.systemd_values import unit_specifiers
from bringup_lint.pattern import regex
from bringup_lint.source import Located
from bringup_lint.source import Source

_GLOB = regex(r"[*?\[]")


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


def environment_files(unit: Unit, files: Files) -> list[EnvironmentFile]:
    """The environment files of a unit, in the order in which they are read; resets count."""
    found = []
    for value in unit.values("EnvironmentFile", unit.section):
        optional = value.startswith("-")
        name = value.part(1, len(value)) if optional else value
        path = None if unit.is_opaque(value) or _GLOB.search(name) else expand(name, unit_specifiers(unit.name))
        source = files.find(path, value.span.source) if path else None
        if path and source is not None and _is_program(source, path):
            source = None
        found.append(EnvironmentFile(name, optional, path, source, _missing(path, source, files)))
    return found


def _is_program(source: Source, path: str) -> bool:
    """Whether a file only has the name of the environment file: ``/usr/lib/rover/rover`` for ``/etc/default/rover``."""
    folder = posixpath.basename(posixpath.dirname(path))
    return source.text.startswith("#!") and posixpath.basename(posixpath.dirname(source.name)) != folder


def _missing(path: str | None, source: Source | None, files: Files) -> bool | None:
    """Whether a path is provably not there."""
    if source is not None:
        return False
    there = files.tree.has(path) if path else None
    return None if there is None else not there


def unit_environment(unit: Unit, files: Files) -> Environment:
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
    for file in environment_files(unit, files):
        _read(environment, file, files)
    for value in unit.values("UnsetEnvironment", unit.section):
        for word in split_words(value).words:
            environment.unset(word.partition("=")[0])
    return environment


def _read(environment: Environment, file: EnvironmentFile, files: Files) -> None:
    if file.source is None or file.path is None:
        environment.complete &= file.missing is True
        return
    model = files.environment_file(file.path)
    if model:
        for entry in model.entries:
            text = None if file.source.template else str(entry.value)
            environment.set(Variable(str(entry.name), entry.value, text, "EnvironmentFile="))
    environment.complete &= not file.source.template


def process_environment(
    process: Process, environment: Environment, files: Files, until: Step | None = None
) -> Environment:
    """The environment of a command line, or of one step of what its shells and scripts run. ``environment`` is that of
    its unit."""
    steps = process.steps[: process.steps.index(until)] if until else process.steps
    found = after_commands(
        environment,
        [step.command for step in steps],
        lambda path: bool(SETUP_FILE.search(path)) or files.tree.find(path) is not None,
    )
    if until is not None:
        assign_before(found, until.command)
    return found
