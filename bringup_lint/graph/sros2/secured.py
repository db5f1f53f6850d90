"""The processes for which security is switched on, and which enclave they select."""

from __future__ import annotations

from collections.abc import Iterable
from collections.abc import Iterator
from typing import TYPE_CHECKING

from bringup_lint.graph.commands.environment import Environment
from bringup_lint.graph.commands.environment import Variable
from bringup_lint.graph.environment.launched import launched_environment
from bringup_lint.graph.launch.started import literal_text
from bringup_lint.graph.sros2.enclaves import OPTION
from bringup_lint.graph.sros2.enclaves import OVERRIDE
from bringup_lint.graph.sros2.enclaves import enclave_of
from bringup_lint.named_tuple import NamedTuple
from bringup_lint.source import Located
from bringup_lint.source import Span

if TYPE_CHECKING:
    from bringup_lint.graph.environment.ros import RosEnvironment
    from bringup_lint.graph.environment.ros import RosProcess
    from bringup_lint.graph.launch.started import Started

ENABLE = "ROS_SECURITY_ENABLE"
STRATEGY = "ROS_SECURITY_STRATEGY"


class Secured(NamedTuple):
    """A process of ROS with security switched on."""

    label: str
    where: Span
    switch: Located
    """The value that switches it on."""
    own: bool
    """Whether that value is for this process alone."""
    by_hand: bool = False
    """Only whoever sources a script switches it on."""
    elsewhere: bool = False
    """Another launch file starts the same program with an enclave."""


def without_enclave(ros: RosEnvironment, nodes: Iterable[Started]) -> list[list[Secured]]:
    """The secured processes that surely select no enclave; those with a common switch together. ``nodes``: the
    processes of launch files."""
    found: dict[Span, dict[Span, Secured]] = {}
    nodes = list(nodes)
    for each in (*_launched(nodes), *_of_launchers(ros), *_of_exports(ros, nodes)):
        if each.where.source.judged:
            found.setdefault(each.switch.span, {}).setdefault(each.where, each)
    return [list(group.values()) for group in found.values()]


def _launched(nodes: Iterable[Started]) -> Iterator[Secured]:
    """Those that their launch files secure themselves."""
    for node in nodes:
        if ENABLE in node.env:
            yield from _of_node(node, launched_environment(Environment(), node))


def _of_launchers(ros: RosEnvironment) -> Iterator[Secured]:
    for launcher in ros.launchers:
        yield from _of_commands(launcher)
        if any(ENABLE in start.environment for start in launcher.starts):
            for each in ros.launched_by(launcher):
                yield from _of_node(each.node, each.environment)


def _of_exports(ros: RosEnvironment, nodes: list[Started]) -> Iterator[Secured]:
    """Those of launch files, where a script that is sourced exports the switch with Enforce, and other nodes of the
    tree select an enclave."""
    enforced = {
        each.value.span.source for each in ros.of(STRATEGY) if each.origin == "export" and each.text == "Enforce"
    }
    switches = [each for each in ros.of(ENABLE) if each.value.span.source in enforced and each.text == "true"]
    chosen = [enclave_of(node)[0] for node in nodes]
    if len(switches) != 1 or not any(chosen) or ros.is_development(switches[0].value):
        return
    programs = {_program(node): node.file.source for node, selects in zip(nodes, chosen) if selects}
    for node, selects in zip(nodes, chosen):
        if node.is_node and not selects and not node.env and not node.own_env:
            elsewhere = programs.get(_program(node), node.file.source) is not node.file.source
            yield Secured(node.label(), node.span, switches[0].value, own=False, by_hand=True, elsewhere=elsewhere)


def _program(node: Started) -> tuple[str | None, str | None]:
    return literal_text(node.package), literal_text(node.executable)


def _of_commands(launcher: RosProcess) -> Iterator[Secured]:
    """The nodes that a command line starts itself."""
    for start in launcher.starts:
        if start.ros.kind not in ("run", "node") or OPTION in start.ros.command.words:
            continue
        switch = _switch(start.environment)
        if switch is not None:
            yield Secured(str(start.ros.where), start.ros.where.span, switch.value, False)


def _of_node(node: Started, environment: Environment) -> Iterator[Secured]:
    chosen, _ = enclave_of(node)
    switch = _switch(environment)
    if node.is_node and not chosen and switch is not None:
        yield Secured(node.label(), node.span, switch.value, switch.origin in ("env", "additional_env"))


def _switch(environment: Environment) -> Variable | None:
    """The variable that switches security on, where nothing overrides the enclave."""
    variable = environment.get(ENABLE)
    return variable if environment.text(ENABLE) == "true" and OVERRIDE not in environment else None
