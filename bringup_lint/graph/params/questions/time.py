"""Nodes of a real robot that a parameter file tells to wait for the time of a simulation."""

from __future__ import annotations

import re
from collections.abc import Iterator
from typing import TYPE_CHECKING

from bringup_lint.facts.ros.simulation import is_simulation
from bringup_lint.graph.launch.expansion import Expansion
from bringup_lint.graph.launch.resolve import text_of
from bringup_lint.graph.launch.resolve import truth
from bringup_lint.graph.launch.started import literal_text
from bringup_lint.graph.params.loads import REPLACED
from bringup_lint.graph.params.loads import REWRITTEN
from bringup_lint.graph.params.loads import Load
from bringup_lint.graph.params.loads import is_replaced
from bringup_lint.model.launch_values import DictValue
from bringup_lint.model.params import Parameter
from bringup_lint.model.params import ParameterFile
from bringup_lint.model.params import matches
from bringup_lint.named_tuple import NamedTuple
from bringup_lint.pattern import regex

if TYPE_CHECKING:
    from bringup_lint.graph.params.params import Params

NAME = "use_sim_time"
_RECORDED = regex(r"(?:^|[^a-z])(?:bag|rosbag2?|replay|tests?)(?:[^a-z]|$)", re.I)
_WAITING = regex(
    r"nav2_(?!map_server|lifecycle_manager|rviz|common)|opennav_|robot_localization$|slam_toolbox$|cartographer_ros$"
    r"|rtabmap_"
)
_HARDWARE = regex(r"(?:^|[^a-z])(?:bringup|hardware|drivers?|real|robot)(?:[^a-z]|$)", re.I)


class Simulated(NamedTuple):
    file: ParameterFile
    parameter: Parameter
    load: Load


def simulated(params: Params) -> Iterator[Simulated]:
    for file in params.judged:
        told = [each for each in file.parameters if each.name == NAME and each.value.data is True]
        if not told or _gives_time(file.source.name):
            continue
        for parameter in told:
            loads = (each for each in params.loads(file) if not params.launch().never_runs(each.node))
            load = next((each for each in loads if _waits(each, parameter)), None)
            if load is not None:
                yield Simulated(file, parameter, load)


def _waits(load: Load, parameter: Parameter) -> bool:
    """Whether a node of a robot's bring-up really gets the value, and nothing there may give it the time."""
    name = load.node.fqn
    reached = matches(parameter.block.name, name) if name else parameter.block.name.strip("/") == "**"
    if not reached or not load.certain or load.how in (REWRITTEN, REPLACED) or load.node.by_default is not True:
        return False
    later = load.node.parameters[load.order + 1 :]
    if is_replaced(load, NAME) or not all(isinstance(value, DictValue) for value in later):
        return False
    expansion = load.expansion
    return not expansion.open and _is_hardware(expansion) and not _simulates(expansion)


def _is_hardware(expansion: Expansion) -> bool:
    return bool(_HARDWARE.search(expansion.entry.source.name))


def _simulates(expansion: Expansion) -> bool:
    if any(_gives_time(file.source.name) for file in expansion.files):
        return True
    for name, binding in expansion.arguments.items():
        if "sim" in name.lower() and truth(binding.value) is not False:
            return True
    for node in expansion.nodes:
        words: list[str | None] = [literal_text(value) for value in (node.package, node.executable, node.plugin)]
        if not node.is_node and not words[0]:
            words = [text_of(value) for value in node.arguments]
        if any(word is None and node.is_node for word in words[:2]) or any(map(_gives_time, filter(None, words))):
            return True
    return False


def _gives_time(name: str) -> bool:
    """Whether a name is that of a simulation or a recording."""
    return is_simulation(name) or _RECORDED.search(name) is not None


def waits_for_time(package: str) -> bool:
    """Whether the nodes of a package compare the time with the stamps of transforms, or have timers in ROS time."""
    return _WAITING.match(package) is not None
