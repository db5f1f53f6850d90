"""What nodes of public packages make of the parameters that files give them: names that they do not have, and types."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from bringup_lint.facts.ros.parameters import PublicNode
from bringup_lint.facts.ros.parameters import controller_of
from bringup_lint.facts.ros.parameters import is_of_library
from bringup_lint.facts.ros.parameters import nav2_words
from bringup_lint.facts.ros.parameters import node_called
from bringup_lint.facts.ros.parameters import public_node
from bringup_lint.graph.launch.started import literal_text
from bringup_lint.graph.memo import kept
from bringup_lint.named_tuple import NamedTuple

if TYPE_CHECKING:
    from bringup_lint.graph.params.loads import Load
    from bringup_lint.graph.params.params import Params
    from bringup_lint.graph.params.values import Item
    from bringup_lint.model.params import Block
    from bringup_lint.model.params import Parameter
    from bringup_lint.model.params import ParameterFile

_OFFICIAL = ("nav2_", "dwb_", "opennav_")
"""Packages of Navigation2 whose plugins declare the types of the table."""
_BEFORE = ("foxy", "galactic")
"""Distributions whose plugins of Navigation2 lack parameters of newer ones, and drop a value whatever its type is."""
_LIBRARIES = "plugin_lib_names"
_MANAGER = "controller_manager"
"""What programs hand the parameters of its controllers to, as they read them from a file."""


class PublicBlock(NamedTuple):
    file: ParameterFile
    block: Block
    node: PublicNode


class Unknown(NamedTuple):
    """Parameters of one block that its node does not have."""

    node: PublicNode
    name: str
    """Of the node."""
    parameters: tuple[Parameter, ...]


def unknown_to_public(params: Params) -> Iterator[Unknown]:
    for file, block, node in _blocks(params):
        if any(each.name == _LIBRARIES and not _is_all_official(params, each) for each in block.parameters):
            continue  # the nodes of a behavior tree ask bt_navigator for parameters of their own
        lacking = [
            each
            for each in block.parameters
            if not (_is_known(each) if node.has_plugins and "." in each.name else node.declares(each.name))
            and not params.is_named_in_code(each.name)
        ]
        is_manager = node.package == _MANAGER
        if lacking and not (is_manager and params.is_read_by_program(file)):
            yield Unknown(node, block.node_name, tuple(lacking))


def _is_all_official(params: Params, libraries: Parameter) -> bool:
    return all(str(item.data).startswith(_OFFICIAL) for item in params.items(libraries))


def of_wrong_public_type(
    params: Params, given: str, declared: str
) -> Iterator[tuple[Parameter, PublicNode, list[Item]]]:
    """The values of one type that a public node declares as another, each with its items; arrays of them too."""
    if not params.is_typed:
        return
    pairs = ((given, declared), (f"{given}_array", f"{declared}_array"))
    for file, block, node in _blocks(params):
        for each in block.parameters:
            type_ = node.type_of(str(each.name)) if _is_official(each, node, params.distribution) else None
            if (each.value.type, type_) in pairs and _arrives(params, file, each):
                yield each, node, params.items(each)


@kept
def _blocks(params: Params) -> list[PublicBlock]:
    workspace = params.launch().workspace
    found: list[PublicBlock] = []
    for file in params.judged:
        if file.accepted and not file.uncertain and params.is_used(file):
            controllers, programs = _controllers(file), _programs(params.loads(file))
            for block in file.blocks:
                node = controllers.get(block.node_name) or _node_of(programs, block)
                if node is not None and node.package not in workspace.packages:
                    found.append(PublicBlock(file, block, node))
    return found


def _controllers(file: ParameterFile) -> dict[str, PublicNode]:
    """The controllers of ros2_control whose class the file gives to the controller manager."""
    types = {
        each.name.removesuffix(".type"): each.value.data for each in file.parameters if each.name.endswith(".type")
    }
    found = ((name, controller_of(str(kind))) for name, kind in types.items())
    return {name: node for name, node in found if node is not None}


def _programs(loads: list[Load]) -> dict[str, set[tuple[str, str]]]:
    """Name of a block that a started node gets a file by -> the package and program of each such node."""
    found: dict[str, set[tuple[str, str]]] = {}
    for node in (load.node for load in loads):
        for name in ("/**", node.fqn) if node.fqn is not None else ("/**",):
            found.setdefault(f"/{name.lstrip('/')}", set()).add((str(literal_text(node.package)), str(node.program)))
    return found


def _node_of(programs: dict[str, set[tuple[str, str]]], block: Block) -> PublicNode | None:
    """The one public node that a block is for: by what launch files start, else by its name. A wildcard is for whatever
    gets the file."""
    started = programs.get(f"/{block.name.lstrip('/')}")
    if not started:
        return node_called(block.node_name)
    nodes = {public_node(package, program) for package, program in started}
    return nodes.pop() if len(nodes) == 1 else None


def _is_known(parameter: Parameter) -> bool:
    """Whether a parameter in a section of a server of Navigation2 may be one of a plugin."""
    words = parameter.name.split(".")
    sections = [".".join(words[:end]) for end in range(len(words) - 1, 0, -1)]
    given = {each.name: str(each.value.data) for each in parameter.block.parameters}
    plugins = [given[f"{each}.plugin"] for each in sections if f"{each}.plugin" in given]
    others = [each for each in sections if not given.get(f"{each}.primary_controller", "nav2_").startswith(_OFFICIAL)]
    if not plugins or others or not plugins[0].startswith(_OFFICIAL):
        return True
    return words[-1] in nav2_words() or is_of_library(parameter.name)


def _is_official(parameter: Parameter, node: PublicNode, distribution: str | None) -> bool:
    """Whether the type of a parameter is known: in a section of Navigation2, by the package of the plugin."""
    section = str(parameter.name).partition(".")
    if not node.has_plugins or not section[1]:
        return True
    if distribution in _BEFORE:
        return False
    plugins = [each.value.data for each in parameter.block.parameters if each.name == f"{section[0]}.plugin"]
    return bool(plugins) and all(str(each).startswith(_OFFICIAL) for each in plugins)


def _arrives(params: Params, file: ParameterFile, parameter: Parameter) -> bool:
    """Whether nothing that a launch file gives later takes the place of a value."""
    return not params.loads(file) or bool(params.effective(file, parameter))
