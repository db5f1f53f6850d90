"""Processes that run together with one identity, though one of them moves the robot, or one has given it its name."""

from __future__ import annotations

from collections.abc import Iterable
from collections.abc import Iterator
from typing import TYPE_CHECKING

from bringup_lint.discover.kinds.launch import LAUNCH
from bringup_lint.graph.launch.started import Started
from bringup_lint.graph.launch.started import literal_text
from bringup_lint.graph.sros2.enclaves import enclave_of
from bringup_lint.graph.sros2.enclaves import in_words
from bringup_lint.model.launch import ComposableNode
from bringup_lint.named_tuple import NamedTuple
from bringup_lint.pattern import regex
from bringup_lint.source import Located

if TYPE_CHECKING:
    from bringup_lint.graph.environment.ros import RosEnvironment
    from bringup_lint.graph.environment.ros import RosProcess
    from bringup_lint.graph.files import Files
    from bringup_lint.graph.launch.launch import Launch

_ACTUATOR = regex(
    r"(?:^|[_-])(?:motors?|wheels?|drives?|base|chassis|actuators?|arm|gripper|thrusters?|servos?|steering|blade)(?:[_-]|$)"
)
_ACTUATOR_ROLES = ("hardware", "control")


class User(NamedTuple):
    """A process and the enclave that it selects."""

    label: str
    enclave: Located
    moves: bool
    """Whether it drives actuators, by its name or by what is known about its program."""


def shared_enclaves(files: Files, ros: RosEnvironment, launch: Launch) -> Iterator[tuple[User, list[User]]]:
    """A process that moves the robot, or after which its enclave is called, and others that run beside it with the same
    enclave."""
    systems = [*_of_systems(ros, launch)]
    if files.of_kind(*LAUNCH):
        systems += _of_entries(ros, launch)
    for users in systems:
        for same in _by_enclave(users):
            moving = [user for user in same if user.moves]
            others = [user for user in same if not user.moves]
            if moving and others:
                yield moving[0], others
                continue
            owner = next((user for user in same if _is_named_after(user)), None)
            if owner is not None and len(same) > 1:
                yield owner, [user for user in same if user is not owner]


def _is_named_after(user: User) -> bool:
    return user.enclave.rpartition("/")[2].lower() == user.label.lower()


def _by_enclave(users: list[User]) -> Iterator[list[User]]:
    """The users of each enclave, each label once."""
    found: dict[str, dict[str, User]] = {}
    for user in users:
        found.setdefault(str(user.enclave), {}).setdefault(user.label, user)
    return (list(same.values()) for same in found.values())


def _of_systems(ros: RosEnvironment, launch: Launch) -> Iterator[list[User]]:
    """The processes of the runners that run together."""
    systems: dict[str, list[User]] = {}
    for launcher in ros.launchers:
        system = launcher.runner.system if launcher.runner is not None else launcher.source.name
        users = systems.setdefault(system, [])
        users += _of_commands(launcher)
        users += _of_nodes((each.node for each in ros.launched_by(launcher)), launch)
    yield from systems.values()


def _of_entries(ros: RosEnvironment, launch: Launch) -> Iterator[list[User]]:
    """The processes of each launch file that no runner starts."""
    run = {each.expansion.entry for launcher in ros.launchers for each in ros.launched_by(launcher)}
    for expansion in launch.entries:
        if expansion.entry not in run and expansion.entry.source.judged:
            yield list(_of_nodes((node for node in expansion.nodes if node.by_default is True), launch))


def _of_commands(launcher: RosProcess) -> Iterator[User]:
    for start in launcher.starts:
        if start.ros.kind in ("run", "node"):
            label = str(start.ros.where).rpartition("/")[2]
            for enclave in in_words(start.ros.command.words):
                yield User(label, enclave, _moves(label))


def _of_nodes(nodes: Iterable[Started], launch: Launch) -> Iterator[User]:
    for node in nodes:
        _, enclave = enclave_of(node)
        if enclave is None or isinstance(node.action, ComposableNode):
            continue
        names = (node.label(), literal_text(node.executable), literal_text(node.package))
        moves = launch.role(node).role in _ACTUATOR_ROLES or any(_moves(name) for name in names if name)
        yield User(node.label(), enclave, moves)


def _moves(name: str) -> bool:
    return bool(_ACTUATOR.search(name))
