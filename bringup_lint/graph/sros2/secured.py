"""The processes for which security is switched on, and which enclave they select."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING
from typing import NamedTuple

from bringup_lint.graph.commands.environment import Environment
from bringup_lint.graph.environment.launched import launched_environment
from bringup_lint.graph.sros2.enclaves import OPTION
from bringup_lint.graph.sros2.enclaves import nodes
from bringup_lint.graph.sros2.enclaves import of_node
from bringup_lint.source import Located
from bringup_lint.source import Span

if TYPE_CHECKING:
    from bringup_lint.graph.launch.started import Started
    from bringup_lint.robot import Robot

ENABLE, OVERRIDE = "ROS_SECURITY_ENABLE", "ROS_SECURITY_ENCLAVE_OVERRIDE"


class Secured(NamedTuple):
    """A process of ROS with security switched on."""

    label: str
    where: Span
    switch: Located
    """The value that switches it on."""
    own: bool
    """Whether that value is for this process alone."""


def without_enclave(robot: Robot) -> list[list[Secured]]:
    """The secured processes that surely select no enclave; those with a common switch together."""
    found: dict[Span, dict[Span, Secured]] = {}
    for each in _all(robot):
        if each.where.source.judged:
            found.setdefault(each.switch.span, {}).setdefault(each.where, each)
    return [list(group.values()) for group in found.values()]


def _all(robot: Robot) -> Iterator[Secured]:
    for node in nodes(robot):
        if ENABLE in node.env:
            yield from _of_node(node, launched_environment(Environment(), node))
    for launcher in robot.ros.launchers:
        for start in launcher.starts:
            words = start.ros.command.words
            if start.ros.kind in ("run", "node") and OPTION not in words and _is_on(start.environment):
                yield Secured(str(start.ros.where), start.ros.where.span, start.environment.get(ENABLE).value, False)
        if any(ENABLE in start.environment for start in launcher.starts):
            for each in robot.ros.launched_by(launcher):
                yield from _of_node(each.node, each.environment)


def _of_node(node: Started, environment: Environment) -> Iterator[Secured]:
    chosen, _ = of_node(node)
    if node.is_node and not chosen and _is_on(environment):
        variable = environment.get(ENABLE)
        yield Secured(node.label(), node.span, variable.value, variable.origin in ("env", "additional_env"))


def _is_on(environment: Environment) -> bool:
    return environment.text(ENABLE) == "true" and OVERRIDE not in environment
