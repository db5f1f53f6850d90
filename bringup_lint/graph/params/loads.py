"""Who loads a parameter file: the nodes of launch files that name it, and by which parser it is read for them."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from bringup_lint.graph.launch.expansion import Expansion
from bringup_lint.graph.launch.resolve import text_of
from bringup_lint.graph.launch.resolve import truth
from bringup_lint.graph.launch.started import Started
from bringup_lint.model.launch import ComposableNode
from bringup_lint.model.launch_values import Choice
from bringup_lint.model.launch_values import Concat
from bringup_lint.model.launch_values import DerivedFile
from bringup_lint.model.launch_values import DictValue
from bringup_lint.model.launch_values import Literal
from bringup_lint.model.launch_values import ParameterFile as LaunchedFile
from bringup_lint.model.launch_values import PathJoin
from bringup_lint.model.launch_values import Value
from bringup_lint.named_tuple import NamedTuple
from bringup_lint.source import Span

if TYPE_CHECKING:
    from bringup_lint.graph.launch.launch import Launch

RCL, SUBSTITUTED, REWRITTEN, REPLACED, PYYAML = "rcl", "substituted", "rewritten", "replaced", "pyyaml"


class Load(NamedTuple):
    """A node that is given a parameter file, in one run of launch."""

    path: str
    """Of the file in the tree, absolute, or as the robot sees it."""
    node: Started
    expansion: Expansion
    where: Span
    """What names the file in the launch file."""
    how: str
    """``rcl``; ``substituted`` when launch fills in ``$(...)`` before; ``rewritten`` by a helper that sets values;
    ``replaced`` by one that changes any text, names included; ``pyyaml`` when launch itself reads the values and sends
    them to a container."""
    root_key: Value | None
    order: int
    """Place among the node's parameters; later ones win."""
    certain: bool
    """Not one of several files of which an argument chooses."""
    substitutes: bool | None
    """Whether launch fills in ``$(...)`` before; None when that depends on something that is not known."""


def loads_in(launch: Launch, expansion: Expansion) -> Iterator[Load]:
    """The loads of files that the tree holds."""
    for node in expansion.nodes:
        for order, value in enumerate(node.parameters):
            for option, certain in _options(value):
                yield from _load(launch, expansion, node, option, order, certain)


def _options(value: Value, certain: bool = True) -> Iterator[tuple[Value, bool]]:
    if isinstance(value, Choice):
        for _, option in value.options:
            yield from _options(option, False)
    else:
        yield value, certain


def _load(
    launch: Launch, expansion: Expansion, node: Started, value: Value, order: int, certain: bool
) -> Iterator[Load]:
    how = PYYAML if isinstance(node.action, ComposableNode) else RCL
    root_key = None
    substitutes: bool | None = False
    where = value.span
    while isinstance(value, (LaunchedFile, DerivedFile, Choice)):
        if isinstance(value, Choice):
            for option, _ in _options(value):
                yield from _load(launch, expansion, node, option, order, False)
            return
        if isinstance(value, DerivedFile):
            how = REPLACED if value.helper == "ReplaceString" or how == REPLACED else REWRITTEN
            root_key, value = value.root_key or root_key, value.base
        else:
            if value.allow_substs is not None:
                substitutes = truth(value.allow_substs, launch=False)
            if substitutes is not False and how == RCL:
                how = SUBSTITUTED
            value = value.file
    if isinstance(value, DictValue):
        return
    path = path_of(launch, value)
    if path is not None:
        yield Load(path, node, expansion, where, how, root_key, order, certain, substitutes)


def path_of(launch: Launch, value: Value) -> str | None:
    found = launch.find(value)
    if found is not None and found.file is not None:
        return found.file
    if isinstance(value, Literal) and isinstance(value.value, str) and value.value.startswith("/"):
        return str(value.value)
    return None


def own_arguments(launch: Launch, expansion: Expansion) -> Iterator[str]:
    """The files in the arguments of programs that are not ROS arguments: the program reads them in its own way."""
    for node in expansion.nodes:
        ros, before = False, ""
        for word in node.arguments:
            text = text_of(word) or ""
            path = None if ros and before == "--params-file" else path_of(launch, word)
            if path is not None:
                yield path
            ros = text != "--" if ros else text == "--ros-args"
            before = text


def is_replaced(load: Load, name: str) -> bool:
    """Whether what comes later in the node's parameters sets a parameter again, or may do so."""
    names = replaced(load)
    return names is None or name in names


def replaced(load: Load) -> frozenset[str] | None:
    """The parameters that what comes later in the node's parameters sets again; None where these may be any."""
    names: set[str] = set()
    for value in load.node.parameters[load.order + 1 :]:
        for option, _ in _options(value):
            if isinstance(option, DictValue):
                keys = [text_of(key) for key, _ in option.items]
                if option.open or None in keys:
                    return None
                names.update(key for key in keys if key is not None)
            elif not isinstance(option, (LaunchedFile, DerivedFile, Literal, PathJoin, Concat)):
                return None
    return frozenset(names)
