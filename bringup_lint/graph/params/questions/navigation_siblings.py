"""Topics and frames of Navigation2 in which two nodes of a file differ, and of which nothing else knows one."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from bringup_lint.facts.ros.node_topics import published
from bringup_lint.graph.params.questions.navigation_blocks import NavigationProblem
from bringup_lint.graph.params.questions.navigation_blocks import by_name
from bringup_lint.graph.purpose import Purpose

if TYPE_CHECKING:
    from bringup_lint.graph.params.params import Params
    from bringup_lint.model.params import Block
    from bringup_lint.model.params import Parameter
    from bringup_lint.model.params import ParameterFile

_FRAME = "robot_base_frame"
_SCAN = "scan_topic"
_PARTS = 3
"""Of the name of a topic: the layer, the source, and ``topic``."""


def two_inputs(params: Params, file: ParameterFile, costmap: Block) -> Iterator[NavigationProblem]:
    """A source of the local costmap with data of the same type, or the frame of the robot, for which the global one has
    another name. Frames are known only where the tree describes the robot."""
    others = [each for each in file.blocks if each.node_name == "global_costmap"]
    if len(others) != 1:
        return
    named, given = by_name(costmap), by_name(others[0])
    theirs = {_source(name): name for name in given if _source(name)}
    for name, own in named.items():
        other = theirs.get(_source(name))
        if other is None:
            continue
        if _source(name) != _FRAME:
            if _data(named, name) == _data(given, other):
                yield from _one_unknown(params, file, own, given[other], "beside")
        elif params.files.of_kind("urdf"):
            yield from _one_unknown(params, file, own, given[other], "base")


def other_scan(params: Params, file: ParameterFile, localization: Block) -> Iterator[NavigationProblem]:
    """The scan of amcl, where no costmap takes it."""
    own = by_name(localization).get(_SCAN)
    scans: list[Parameter] = []
    for block in file.blocks:
        named = by_name(block)
        for name, each in named.items():
            kind = named.get(f"{name.removesuffix('.topic')}.data_type")
            if name.endswith(".topic") and kind is not None and kind.value.data == "LaserScan":
                scans.append(each)
    if own is None or _plain(own) in {_plain(each) for each in scans}:
        return
    for scan in scans:
        found = list(_one_unknown(params, file, own, scan, "beside"))
        if found and found[0].where == own.span:
            yield from found
            return


def _data(named: dict[str, Parameter], topic: str) -> object:
    """The type of the data of a source, which is LaserScan where none is given."""
    kind = named.get(f"{topic.removesuffix('topic')}data_type")
    return kind.value.data if kind is not None else "LaserScan"


def _source(name: str) -> str:
    parts = name.split(".")
    return ".".join(parts[-2:]) if len(parts) == _PARTS and parts[-1] == "topic" else name if name == _FRAME else ""


def _plain(parameter: Parameter) -> str | None:
    value = parameter.value.data
    return value.lstrip("/") if isinstance(value, str) and value and not set(value) & set("<$ ") else None


def _one_unknown(
    params: Params, file: ParameterFile, own: Parameter, other: Parameter, kind: str
) -> Iterator[NavigationProblem]:
    """The side that no other file of the robot names, where another one names the other side."""
    ours, theirs = _plain(own), _plain(other)
    if ours is None or theirs is None or ours == theirs:
        return
    known = [_is_known(params, file, each) for each in (ours, theirs)]
    if known == [False, True]:
        yield NavigationProblem(kind, own.span, str(own.value.data), str(other.value.data), other.span)
    elif known == [True, False]:
        yield NavigationProblem(kind, other.span, str(other.value.data), str(own.value.data), own.span)


def _is_known(params: Params, file: ParameterFile, name: str) -> bool:
    """Whether another file of the robot names a topic or frame, or a public driver publishes the topic by default."""
    if name in published():
        return True
    aside = {each for each in params.files.sources if params.files.purpose(each) is not Purpose.ROBOT}
    return params.named_elsewhere(name, aside | {file.source})
