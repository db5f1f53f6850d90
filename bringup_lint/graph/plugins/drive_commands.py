"""Commands without a time stamp for drive controllers that take only stamped ones."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from bringup_lint.graph.launch.started import literal_text
from bringup_lint.named_tuple import NamedTuple
from bringup_lint.source import Located

if TYPE_CHECKING:
    from bringup_lint.graph.launch.launch import Launch
    from bringup_lint.graph.params.params import Params
    from bringup_lint.model.params import Parameter
    from bringup_lint.source import Span

_DRIVE = "diff_drive_controller/DiffDriveController"
_TOPIC = "cmd_vel_unstamped"
_SWITCH = "use_stamped_vel"
_STAMPING = ("TwistStamped", "use_stamped", "publish_stamped_twist", "enable_stamped_cmd_vel", "stamped")
"""Words by which publishers of commands are told to send a stamp."""
_STAMPED = ("jazzy", "kilted", "lyrical", "rolling")
"""Releases whose diff_drive_controller has neither the topic nor the parameter (diff_drive_controller.cpp and
diff_drive_controller_parameter.yaml of ros2_controllers)."""


class Unstamped(NamedTuple):
    controller: str
    where: Span
    """The name of the topic in a remapping, or the parameter."""
    others: tuple[Span, ...]
    distribution: str
    is_topic: bool


def unstamped_commands(launch: Launch, params: Params) -> Iterator[Unstamped]:
    """For each controller the topic and the parameter together."""
    distribution = params.distribution
    if distribution not in _STAMPED or _may_be_stamped(launch, params):
        return
    for controller, switches in _drives(params).items():
        topics = list(dict.fromkeys(name.span for name in _topics(launch, controller)))
        given = [each.span for each in switches]
        if topics or (given and not _is_stamped(params)):
            first, *others = [*topics, *given]
            yield Unstamped(controller, first, tuple(others), str(distribution), bool(topics))


def _may_be_stamped(launch: Launch, params: Params) -> bool:
    """Whether something between the old topic and the controller may add the stamp."""
    programs = (f"{literal_text(node.package)} {literal_text(node.executable)}" for node in launch.nodes)
    if any("stamper" in program for program in programs):
        return True
    return params.named_elsewhere(_TOPIC, {node.file.source for node in launch.nodes})


def _is_stamped(params: Params) -> bool:
    """Whether the tree sends commands with a stamp, so that the parameter is a harmless rest."""
    return any(params.named_elsewhere(word, set()) for word in _STAMPING)


def _drives(params: Params) -> dict[str, list[Parameter]]:
    """Drive controllers of parameter files, with where these ask for commands without a stamp."""
    found: dict[str, list[Parameter]] = {}
    for file, each in params.parameters:
        if each.name.endswith(".type") and each.value.data == _DRIVE and params.is_used(file):
            found.setdefault(each.name.removesuffix(".type"), [])
    for file, each in params.named(_SWITCH):
        controller = each.block.node_name
        if controller in found and each.value.data is False and params.is_used(file):
            found[controller].append(each)
    return found


def _topics(launch: Launch, controller: str) -> Iterator[Located]:
    """The topic in the remappings of launched nodes."""
    for node in launch.nodes:
        if node.file.source.judged:
            for name in (literal_text(side) for pair in node.remappings for side in pair):
                if name is not None and f"/{name}".endswith(f"/{controller}/{_TOPIC}"):
                    yield name
