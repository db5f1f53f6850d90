"""What drive controllers of ros2_control take as commands, and who sends them something else."""

from __future__ import annotations

from collections.abc import Iterable
from collections.abc import Iterator
from typing import TYPE_CHECKING

from bringup_lint.graph.launch.resolve import text_of
from bringup_lint.graph.plugins.controllers import is_manager
from bringup_lint.graph.plugins.controllers import spawned
from bringup_lint.graph.topics.questions.coexistence import coexist
from bringup_lint.graph.topics.resolved.parameters import given_parameters
from bringup_lint.graph.topics.resolved.process_arguments import ros_arguments
from bringup_lint.graph.topics.resolved.velocity_types import STAMPED
from bringup_lint.graph.topics.resolved.velocity_types import TWIST
from bringup_lint.named_tuple import NamedTuple

if TYPE_CHECKING:
    from bringup_lint.graph.launch.started import Started
    from bringup_lint.graph.topics.resolved.endpoint_use import LaunchedNode
    from bringup_lint.graph.topics.resolved.endpoint_use import Running
    from bringup_lint.graph.topics.resolved.endpoint_use import Use
    from bringup_lint.graph.topics.resolved.parameters import ParameterSources
    from bringup_lint.graph.topics.topics import Topics
    from bringup_lint.model.launch_values import Value
    from bringup_lint.source import Span

_DRIVE = "diff_drive_controller/DiffDriveController"
_OTHER = "cmd_vel_unstamped"
_MANAGER = "controller_manager"
_SWITCHED = ("humble", "iron")
"""Releases in which ``use_stamped_vel`` chooses between two topics (diff_drive_controller.cpp)."""
_STAMPED = ("jazzy", "kilted", "lyrical")
"""Releases that know only one topic, so that what their launch files say of the other is told elsewhere."""
_OTHER_NAMES = ("--controller-ros-args", "-n", "--namespace")
"""Options of the spawner that may give a controller other topics."""


class DriveInput(NamedTuple):
    """The one topic on which a controller takes commands."""

    controller: str
    manager: LaunchedNode
    topic: str
    type: str
    other: str
    """The topic of the other type, to which it does not listen."""
    where: Span
    """The parameter that decides, or the manager in the launch file."""


class Unheard(NamedTuple):
    drive: DriveInput
    uses: list[Use]
    """Publishers of commands that the controller never gets."""


def unheard_commands(topics: Topics) -> Iterator[Unheard]:
    """Each controller once, with what surely starts beside it."""
    sources, distribution = topics.parameter_sources, topics.params().distribution
    own = _DRIVE.partition("/")[0] in topics.launch.workspace.packages
    if own or distribution not in (None, *_SWITCHED, *_STAMPED):
        return
    seen: set[tuple[Span, str]] = set()
    for running in topics.runs:
        for drive in _drive_inputs(running, sources, distribution):
            heard = distribution in _STAMPED or _is_heard(topics, running, drive.other)
            others = [] if heard else [drive.other]
            uses = {use.where: use for use in _unheard(running, drive, others)}
            key = (drive.manager.started.span, drive.controller)
            if uses and key not in seen:
                seen.add(key)
                yield Unheard(drive, list(uses.values()))


def _unheard(running: Running, drive: DriveInput, others: list[str]) -> Iterator[Use]:
    """What surely starts beside the controller; not a node that also sends what the controller takes."""
    sent = [use for use in running.uses if use.role == "publisher" and coexist(use.node, drive.manager)]
    heard = {use.node.started for use in sent if use.topic == drive.topic and use.type in (None, drive.type)}
    for use in sent:
        lost = use.topic in others or (use.topic == drive.topic and {use.type, drive.type} == {TWIST, STAMPED})
        if lost and not use.conditional and use.node.started not in heard:
            yield use


def _is_heard(topics: Topics, running: Running, topic: str) -> bool:
    """Whether another node takes what is sent to a topic, or may do so to add the stamp."""
    ends = [use for use in running.uses if use.topic == topic]
    if any(use.role == "subscription" for use in ends):
        return True
    sources = {node.file.source for node in topics.launch.nodes} | {use.where.source for use in ends}
    sending = {use.node.started for use in ends}
    others = (node.started for node in running.nodes if node.started not in sending)
    names = [text_of(name) for name in _renamed(others)]
    return any(name is None or _OTHER in name for name in names) or topics.params().named_elsewhere(_OTHER, sources)


def _renamed(nodes: Iterable[Started]) -> Iterator[Value]:
    return (name for node in nodes for pair in node.remappings for name in pair)


def _drive_inputs(running: Running, sources: ParameterSources, distribution: str | None) -> Iterator[DriveInput]:
    managers = [node for node in running.nodes if is_manager(node.started)]
    if len(managers) != 1 or not _is_plain(managers[0]):
        return
    manager = managers[0]
    arguments = ros_arguments(manager.started)
    own = given_parameters(sources, manager.started, f"/{_MANAGER}", arguments)
    for spawner, name in spawned([node.started for node in running.nodes]):
        words = {str(text_of(word)).partition("=")[0] for word in spawner.arguments}
        typed = own.values.get(f"{name}.type")
        if typed is None or typed.value != _DRIVE or words & set(_OTHER_NAMES):
            continue
        given = given_parameters(sources, manager.started, f"/{name}", arguments)
        switch = given.values.get("use_stamped_vel") if distribution not in _STAMPED else None
        stamped = True if switch is None else switch.value
        known = switch is not None or not given.open or distribution in _STAMPED
        if known and (stamped is True or (stamped is False and distribution in _SWITCHED)):
            yield _input(str(name), manager, stamped, switch.where if switch is not None else manager.started.span)


def _input(name: str, manager: LaunchedNode, stamped: bool, where: Span) -> DriveInput:
    with_stamp, without = f"/{name}/cmd_vel", f"/{name}/{_OTHER}"
    if stamped:
        return DriveInput(name, manager, with_stamp, STAMPED, without, where)
    return DriveInput(name, manager, without, TWIST, with_stamp, where)


def _is_plain(manager: LaunchedNode) -> bool:
    """Whether its controllers have the names and topics that they give themselves."""
    started = manager.started
    names = [text_of(name) for name in _renamed([started])]
    remapped = any(name is None or "cmd_vel" in name for name in names)
    return manager.namespace == "/" and started.name is None and not started.arguments and not remapped
