"""Processes that run together with one identity, though one of them moves the robot."""

from __future__ import annotations

import re
from collections.abc import Iterator
from typing import TYPE_CHECKING
from typing import NamedTuple

from bringup_lint.graph.launch.started import Started
from bringup_lint.graph.launch.started import literal_text
from bringup_lint.graph.sros2.enclaves import in_words
from bringup_lint.graph.sros2.enclaves import of_node
from bringup_lint.model.launch import ComposableNode
from bringup_lint.source import Located

if TYPE_CHECKING:
    from bringup_lint.robot import Robot

_ACTUATOR = re.compile(
    r"(?:^|[_-])(?:motors?|wheels?|drives?|base|chassis|actuators?|arm|gripper|thrusters?|servos?|steering|blade)(?:[_-]|$)"
)
_ACTUATOR_ROLES = ("hardware", "control")


class User(NamedTuple):
    """A process and the enclave that it selects."""

    label: str
    enclave: Located
    moves: bool
    """Whether it drives actuators, by its name or by what is known about its program."""


def shared_enclaves(robot: Robot) -> Iterator[tuple[User, list[User]]]:
    """A process that moves the robot, and others that run beside it with the same enclave."""
    for users in _together(robot):
        by_enclave: dict[str, dict[Located, User]] = {}
        for user in users:
            by_enclave.setdefault(str(user.enclave), {}).setdefault(user.label, user)
        for same in by_enclave.values():
            moving = [user for user in same.values() if user.moves]
            others = [user for user in same.values() if not user.moves]
            if moving and others:
                yield moving[0], others


def _together(robot: Robot) -> Iterator[list[User]]:
    """The processes of one launch file, or of the units of one place."""
    launched = set()
    for launcher in robot.ros.launchers:
        launched |= {id(each.expansion.entry) for each in robot.ros.launched_by(launcher)}
    by_place: dict[object, list[User]] = {}
    for launcher in robot.ros.launchers:
        users = by_place.setdefault(launcher.unit.place if launcher.unit else launcher.source.name, [])
        for start in launcher.starts:
            if start.ros.kind in ("run", "node"):
                label = str(start.ros.where).rpartition("/")[2]
                users += [User(label, each, _moves(label)) for each in in_words(start.ros.command.words)]
        nodes = (each.node for each in robot.ros.launched_by(launcher))
        users += [user for node in nodes if (user := _of_node(node, robot))]
    yield from by_place.values()
    if robot.of_kind("launch-python", "launch-xml", "launch-yaml"):
        for expansion in robot.launch.entries:
            if id(expansion.entry) not in launched and expansion.entry.source.judged:
                sure = (node for node in expansion.nodes if node.by_default is True)
                yield [user for node in sure if (user := _of_node(node, robot))]


def _of_node(node: Started, robot: Robot) -> User | None:
    _, enclave = of_node(node)
    if enclave is None or isinstance(node.action, ComposableNode):
        return None
    names = (node.label(), literal_text(node.executable), literal_text(node.package))
    moves = robot.launch.role(node).role in _ACTUATOR_ROLES or any(_moves(name) for name in names if name)
    return User(node.label(), enclave, moves)


def _moves(name: str) -> bool:
    return bool(_ACTUATOR.search(name))
