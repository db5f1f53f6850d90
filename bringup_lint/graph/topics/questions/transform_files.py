"""Drive controllers that publish, as their parameter file says, the transform of a filter that takes their odometry."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from bringup_lint.discover.kinds.launch import LAUNCH
from bringup_lint.discover.starters import STARTING
from bringup_lint.graph.launch.resolve import text_of
from bringup_lint.graph.launch.started import literal_text
from bringup_lint.graph.plugins.controllers import is_manager
from bringup_lint.graph.plugins.controllers import spawned_by
from bringup_lint.graph.purpose import Purpose
from bringup_lint.graph.topics.questions.apart import are_together
from bringup_lint.graph.topics.questions.transform_sources import DRIVE
from bringup_lint.graph.topics.questions.transform_sources import FILTERS
from bringup_lint.graph.topics.questions.transform_sources import TransformSource
from bringup_lint.graph.topics.questions.transform_sources import filter_source
from bringup_lint.graph.topics.resolved.names import tail
from bringup_lint.graph.topics.resolved.parameters import given_parameters
from bringup_lint.graph.topics.resolved.process_arguments import ros_arguments
from bringup_lint.model.launch_values import DictValue
from bringup_lint.pattern import regex

if TYPE_CHECKING:
    from bringup_lint.graph.launch.started import Started
    from bringup_lint.graph.topics.resolved.parameters import GivenParameters
    from bringup_lint.graph.topics.topics import Topics
    from bringup_lint.model.params import Block
    from bringup_lint.model.params import ParameterFile
    from bringup_lint.source import Span

SWITCH = "enable_odom_tf"
_GIVING = ("shell-script", *STARTING, *LAUNCH)
"""Kinds of files that may give a parameter to a controller."""
_PREFIX = "tf_frame_prefix"
_INPUT = regex(r"odom\d+\Z")


def rivals_in_files(topics: Topics) -> Iterator[tuple[TransformSource, TransformSource]]:
    """A controller and a filter that a launch file starts, and that takes the odometry of the controller or starts with
    its spawner. Silent where controllers of one name differ, and where a launch file or script gives the switch."""
    known = dict(drives(topics))
    said = {each.name.rpartition("/")[2] for pair in topics.rival_transforms for each in pair}
    if not known or any(SWITCH in each.text for each in topics.files.of_kind(*_GIVING)):
        return
    for started, given, source in filters(topics):
        for name, of_name in known.items():
            rivals = [each for each in of_name if _is_rival(topics, each, source)]
            is_said = not said.isdisjoint((name, source.name.rpartition("/")[2]))
            if rivals and not is_said and (_takes(topics, given, name) or _is_beside(topics, started, name)):
                yield rivals[0], source


def _is_rival(topics: Topics, one: TransformSource, other: TransformSource) -> bool:
    is_same = (one.parent, one.child) == (other.parent, other.child)
    return is_same and are_together(topics, one.where.source, other.where.source)


def filters(topics: Topics) -> Iterator[tuple[Started, GivenParameters, TransformSource]]:
    for started in topics.launch.nodes:
        program = str(literal_text(started.executable))
        if literal_text(started.package) != "robot_localization" or program not in FILTERS:
            continue
        if started.by_default is False or started.arguments or _moves_transforms(started):
            continue
        if topics.files.purpose(started.file.source) is not Purpose.ROBOT:
            continue
        name = literal_text(started.name) if started.name is not None else program.replace("_node", "_filter_node")
        given = given_parameters(topics.parameter_sources, started, f"/{name}", ros_arguments(started))
        if name is not None and not given.open:
            found = filter_source(topics.node(started), given, f"/{name}")
            yield from ((started, given, each) for each in found)


def drives(topics: Topics) -> Iterator[tuple[str, list[TransformSource]]]:
    """The controllers by name, where all blocks of the name, and their managers, publish the transform alike."""
    managers = [node for node in topics.launch.nodes if is_manager(node)]
    if not managers or any(_moves_transforms(each) or _may_be_given_more(topics, each) for each in managers):
        return
    files = [each for each in topics.params().judged if topics.files.purpose(each.source) is Purpose.ROBOT]
    types = [_types(file) for file in files]
    node = topics.node(managers[0])
    for name in sorted({name for typed in types for name, kind in typed.items() if kind == DRIVE}):
        of_kind = [file for file, typed in zip(files, types, strict=True) if typed.get(name, DRIVE) == DRIVE]
        found = [_drive(block) for file in of_kind for block in file.blocks if block.node_name == name]
        alike = [TransformSource(node, name, *each[:2], SWITCH, each[2]) for each in found if each is not None]
        if len(alike) == len(found) and len({each[:2] for each in found if each is not None}) == 1:
            yield name, alike


def _types(file: ParameterFile) -> dict[str, object]:
    """The types of controllers that a file gives to their manager."""
    parameters = (each for block in file.blocks for each in block.parameters)
    return {each.name.removesuffix(".type"): each.value.data for each in parameters if each.name.endswith(".type")}


def _drive(block: Block) -> tuple[str, str, Span] | None:
    """The frames between which a controller publishes, and where this is said; None when it may not."""
    values = {each.name: each for each in block.parameters}
    switch = values.get(SWITCH)
    data = {name: each.value.data for name, each in values.items()}
    parent, child = data.get("odom_frame_id", "odom"), data.get("base_frame_id", "base_link")
    if data.get(SWITCH, True) is not True or data.get(_PREFIX) or not isinstance(parent, str):
        return None
    return (parent, child, switch.span if switch else block.key.span) if isinstance(child, str) else None


def _moves_transforms(started: Started) -> bool:
    """Whether a remapping may take transforms to another topic than /tf, or is not known."""
    pairs = [(text_of(old), text_of(new)) for old, new in started.remappings]
    return any(old is None or (tail(old) == "tf" and (new or "").lstrip("/") != "tf") for old, new in pairs)


def _may_be_given_more(topics: Topics, manager: Started) -> bool:
    """Whether a manager gets several files of which one is not known."""
    files = [each for each in manager.parameters if not isinstance(each, DictValue)]
    return len(files) > 1 and any(topics.parameter_sources.file(each) is None for each in files)


def _takes(topics: Topics, given: GivenParameters, name: str) -> bool:
    """Whether a filter takes the odometry of a controller, under its own name or the one that a remapping gives it."""
    inputs = [str(each.value) for key, each in given.values.items() if _INPUT.match(key)]
    own = f"{name}/odom"
    if any(f"/{each}".endswith(f"/{own}") for each in inputs):
        return True
    pairs = (pair for node in topics.launch.nodes for pair in node.remappings)
    moved = {str(text_of(new)).strip("/") for old, new in pairs if str(text_of(old)).strip("/") == own}
    return any(each.strip("/") in moved for each in inputs)


def _is_beside(topics: Topics, started: Started, name: str) -> bool:
    """Whether a launch file that starts a filter surely spawns the controller as well."""
    for expansion in topics.launch.entries:
        nodes = [each for each in expansion.nodes if each.by_default is True]
        if any(each.action is started.action for each in nodes) and any(map(is_manager, nodes)):
            if any(name == spawned for each in nodes for spawned in spawned_by(each)):
                return True
    return False
