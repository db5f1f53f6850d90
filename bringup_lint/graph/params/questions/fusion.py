"""Sensors that robot_localization never subscribes, because it counts them and stops at the first missing one."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from bringup_lint.discover.kinds.launch import LAUNCH
from bringup_lint.named_tuple import NamedTuple
from bringup_lint.pattern import regex

if TYPE_CHECKING:
    from bringup_lint.graph.files import Files
    from bringup_lint.graph.params.params import Params
    from bringup_lint.model.params import Parameter
    from bringup_lint.model.params import ParameterFile

_SENSOR = regex(r"(?P<kind>odom|imu|pose|twist)(?P<number>\d{1,2})\Z")


class SkippedSensor(NamedTuple):
    file: ParameterFile
    parameter: Parameter
    missing: str
    """The sensor at which the filter stops."""
    others: tuple[Parameter, ...]
    """The further ones of the kind, which are skipped, too."""


def skipped_sensors(files: Files, params: Params) -> Iterator[SkippedSensor]:
    """The first skipped sensor of each kind and node, where nothing else gives the node the missing one."""
    for file in params.judged:
        for kind, sensors in _sensors(file).items():
            numbers = [number for number in range(max(sensors)) if number not in sensors]
            later = [each for number, each in sorted(sensors.items()) if numbers and number > numbers[0]]
            missing = f"{kind[1]}{numbers[0]}" if numbers else ""
            if later and file.accepted and not _is_named(files, params, file, missing):
                yield SkippedSensor(file, later[0], missing, tuple(later[1:]))


def _sensors(file: ParameterFile) -> dict[tuple[str, str], dict[int, Parameter]]:
    """The sensors with a topic, by the name of their node, by their kind and number."""
    found: dict[tuple[str, str], dict[int, Parameter]] = {}
    for each in file.parameters:
        match = _SENSOR.match(each.name)
        if match is not None and isinstance(each.value.data, str) and each.value.data:
            found.setdefault((each.block.name, match["kind"]), {})[int(match["number"])] = each
    return {key: sensors for key, sensors in found.items() if _is_fused(file, key[0], sensors)}


def _is_fused(file: ParameterFile, block: str, sensors: dict[int, Parameter]) -> bool:
    """Whether a block has switches for one of the sensors: other nodes have parameters called ``odom1``, too."""
    wanted = {f"{each.name}_config" for each in sensors.values()}
    return any(each.name in wanted and each.block.name == block for each in file.parameters)


def _is_named(files: Files, params: Params, file: ParameterFile, name: str) -> bool:
    """Whether a launch file may give the node the missing sensor, or another file that the same node loads."""
    loads = params.loads(file)
    launched = {load.node.file.source.name: load.node.file.source for load in loads}
    texts = [source.text for source in launched.values() or files.of_kind(*LAUNCH)]
    if any(word in text for text in texts for word in (f"'{name}'", f'"{name}"')):
        return True
    nodes = {id(load.node) for load in loads}
    beside = (each for each in params.parameter_files if any(id(load.node) in nodes for load in params.loads(each)))
    return any(each.name == name for other in beside for each in other.parameters)
