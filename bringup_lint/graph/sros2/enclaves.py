"""Who selects which enclave: ``--enclave`` in launch files, units, compose files and scripts, and the override
variable."""

from __future__ import annotations

from collections.abc import Iterable
from collections.abc import Iterator
from typing import TYPE_CHECKING

from bringup_lint.discover.kinds.launch import LAUNCH
from bringup_lint.graph.launch.resolve import text_of
from bringup_lint.graph.launch.started import Started
from bringup_lint.graph.launch.started import literal_text
from bringup_lint.model.launch import ComposableNode
from bringup_lint.source import Located

if TYPE_CHECKING:
    from bringup_lint.robot import Robot

OPTION = "--enclave"


def nodes(robot: Robot) -> list[Started]:
    """Every process that the launch files start, each once."""
    if not robot.of_kind(*LAUNCH):
        return []
    found = {}
    for node in robot.launch.nodes:
        if not isinstance(node.action, ComposableNode):
            found.setdefault((id(node.span.source), node.span.start), node)
    return list(found.values())


def of_node(node: Started) -> tuple[bool, Located | None]:
    """Whether a node may select an enclave, and the one it does select, when that is known."""
    values = list(node.arguments)
    for at, value in enumerate(values):
        text = text_of(value)
        if text is None:
            return True, None
        if OPTION in text.split():
            after = text.split()[text.split().index(OPTION) + 1 :]
            if after:
                return True, None
            return True, literal_text(values[at + 1]) if at + 1 < len(values) else None
    return False, None


def in_words(words: Iterable[Located]) -> Iterator[Located]:
    """The enclaves that a command line names."""
    before = ""
    for word in words:
        if before == OPTION and "$" not in word and "{" not in word:
            yield word
        before = str(word)


def selected(robot: Robot) -> Iterator[Located]:
    """Every enclave that something of the tree names, where it is written."""
    for node in nodes(robot):
        _, enclave = of_node(node)
        if enclave is not None:
            yield enclave
    if robot.of_kind("systemd-unit", "systemd-dropin"):
        for unit in robot.units.judged:
            for value in unit.values("ExecStart", unit.section):
                yield from in_words(value.words())
    if robot.of_kind("compose"):
        for service in robot.compose.services:
            yield from in_words(service.command)
    for command in _script_commands(robot):
        yield from in_words(command.words)
    for setting in robot.ros.of("ROS_SECURITY_ENCLAVE_OVERRIDE"):
        if "$" not in setting.value:
            yield setting.value


def _script_commands(robot: Robot):
    from bringup_lint.parsers.shell import commands

    for source in robot.of_kind("shell-script"):
        if OPTION in source.text and not source.template:
            yield from commands(source.located(0, len(source.text)))
