"""Plugins that a server of Navigation2 is told to load, without the class of them."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from bringup_lint.facts.ros.nav2_plugins import LISTS
from bringup_lint.graph.params.values import items
from bringup_lint.model.yaml_node import Sequence
from bringup_lint.named_tuple import NamedTuple
from bringup_lint.spelling import nearest

if TYPE_CHECKING:
    from bringup_lint.graph.params.params import Params
    from bringup_lint.model.params import Parameter
    from bringup_lint.model.params import ParameterFile
    from bringup_lint.source import Span


class UntypedPlugin(NamedTuple):
    """A name of a list, without ``<name>.plugin`` for its class."""

    name: str
    where: Span
    server: str
    like: Parameter | None
    """The ``plugin`` of a nearly equal name that no list holds."""
    used: bool
    """Something names the file, or gives it to a node."""


def untyped_plugins(params: Params) -> Iterator[list[UntypedPlugin]]:
    """Those of one file together."""
    for file in params.judged:
        if file.accepted and not file.uncertain and not _is_completed(params, file):
            found = [each for parameter in file.parameters for each in _of_list(file, parameter, params.is_used(file))]
            if found:
                yield found


def _of_list(file: ParameterFile, parameter: Parameter, used: bool) -> Iterator[UntypedPlugin]:
    server = parameter.block.node_name
    known = LISTS.get(server, {}).get(parameter.name)
    is_costmap = server.endswith("_costmap")
    if known is None or not isinstance(parameter.node, Sequence):
        return
    if not is_costmap or parameter.block.name.endswith(f"{server}/{server}"):
        yield from _untyped(file, parameter, server, known, used)


def _is_completed(params: Params, file: ParameterFile) -> bool:
    """Whether a node that loads the file gets other parameters, too, beside a switch or two in the launch file."""
    return any(_files(load.node.parameters) > 1 for load in params.loads(file))


def _files(values: tuple[object, ...]) -> int:
    from bringup_lint.model.launch_values import DictValue

    return sum(not isinstance(value, DictValue) or value.open for value in values)


def _untyped(
    file: ParameterFile, parameter: Parameter, server: str, known: tuple[str, ...], used: bool
) -> Iterator[UntypedPlugin]:
    names = [item.text for item in items(parameter)]
    if names == list(known):
        return
    typed = {
        each.name.removesuffix(".plugin"): each
        for each in file.parameters
        if each.name.endswith(".plugin") and _reaches(each, server)
    }
    unlisted = [each for each in typed if each not in names]
    for item, name in zip(items(parameter), names, strict=True):
        if name and "$" not in name and name not in typed:
            near = nearest(name, unlisted, 4) or [each for each in unlisted if _holds(each, name)]
            yield UntypedPlugin(name, item.span, server, typed[near[0]] if len(near) == 1 else None, used)


def _holds(one: str, other: str) -> bool:
    return one.endswith(other) or other.endswith(one)


def _reaches(parameter: Parameter, server: str) -> bool:
    """Whether a block may be for a server: it names it, or has a wildcard in the last place."""
    key = parameter.block.node_name
    return key == server or "*" in key
