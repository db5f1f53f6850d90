"""Controllers that are activated together and claim the same interface of a joint."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from bringup_lint.graph.launch.started import literal_text
from bringup_lint.graph.params.values import items
from bringup_lint.graph.plugins.controllers import spawned
from bringup_lint.named_tuple import NamedTuple
from bringup_lint.source import Located
from bringup_lint.source import Span

if TYPE_CHECKING:
    from bringup_lint.graph.launch.expansion import Expansion
    from bringup_lint.graph.launch.launch import Launch
    from bringup_lint.graph.params.params import Params
    from bringup_lint.model.params import ParameterFile

_PASSIVE = ("--inactive", "--stopped", "--load-only")
_TYPES = ("joint_trajectory_controller/", "position_controllers/", "velocity_controllers/", "effort_controllers/")
"""Controllers that claim the command interfaces of all joints in ``joints``."""


class Claim(NamedTuple):
    joint: str
    where: Span
    """The joints of the second controller."""
    controller: str
    first: str
    before: Span
    """The joints of the first controller."""
    spawned: Located


def claims(launch: Launch, params: Params) -> Iterator[Claim]:
    """Each parameter once, where one launch file activates both controllers in any case."""
    said: set[Span] = set()
    for expansion in launch.entries:
        active = _active(expansion)
        for found in (claim for file in params.judged for claim in _of_file(file, active)):
            if found.where not in said:
                said.add(found.where)
                yield found


def _active(expansion: Expansion) -> dict[str, Located]:
    found: dict[str, Located] = {}
    for spawner, name in spawned(expansion.nodes):
        words = {str(literal_text(word)) for word in spawner.arguments}
        is_plain = spawner.by_default is True and not spawner.conditions and not spawner.context
        if is_plain and not words & set(_PASSIVE) and spawner.file.source.judged:
            found.setdefault(str(name), name)
    return found


def _of_file(file: ParameterFile, active: dict[str, Located]) -> Iterator[Claim]:
    if len(active) < 2:
        return
    types = {each.name.removesuffix(".type"): str(each.value.data) for each in file.parameters}
    own: dict[str, dict[str, tuple[set[str], Span]]] = {}
    for each in file.parameters:
        name = str(each.block.key).rpartition("/")[2]
        if name in active and types.get(name, "").startswith(_TYPES) and each.name in ("joints", "command_interfaces"):
            own.setdefault(name, {})[each.name] = ({item.text for item in items(each)}, each.span)
    known = [(name, given) for name, given in own.items() if len(given) == 2]
    for at, (name, given) in enumerate(known):
        for first, before in known[:at]:
            joints = sorted(given["joints"][0] & before["joints"][0])
            if joints and given["command_interfaces"][0] & before["command_interfaces"][0]:
                yield Claim(joints[0], given["joints"][1], name, first, before["joints"][1], active[name])
                break
