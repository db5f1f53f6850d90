"""The one graph of a robot: every layer, joined by the references that files make."""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING

from bringup_lint.discover.kinds.launch import LAUNCH
from bringup_lint.graph.graph import Graph
from bringup_lint.graph.places import Places

if TYPE_CHECKING:
    from bringup_lint.robot import Robot

UNITS = ("systemd-unit", "systemd-dropin")


def joined_graph(robot: Robot) -> Graph:
    """Everything that the files of the tree name. What they only share a repository with is not joined."""
    graph = Graph()
    for add in (_add_units, _add_services, _add_launch, _add_files):
        _try(add, graph, robot)
    places = Places(graph)
    for join in (_add_network, _add_dds, _add_security, _add_devices):
        _try(join, graph, robot, places)
    for ends in (graph.out, graph.into):
        for node, edges in ends.items():
            ends[node] = list(dict.fromkeys(edges))
    return graph


def _try(add: Callable[..., None], graph: Graph, robot: Robot, *more: Places) -> None:
    """A layer that fails costs itself alone."""
    try:
        add(graph, robot, *more)
    except Exception as error:
        graph.failures.append(error)


def _add_units(graph: Graph, robot: Robot) -> None:
    if not robot.of_kind(*UNITS):
        return
    from bringup_lint.graph.edges.boot_ranks import boot_ranks
    from bringup_lint.graph.edges.environment import environment_edges
    from bringup_lint.graph.edges.environment import environment_places
    from bringup_lint.graph.edges.runs import run_edges
    from bringup_lint.graph.edges.runs import script_places
    from bringup_lint.graph.edges.systemd import KINDS
    from bringup_lint.graph.edges.systemd import unit_edges
    from bringup_lint.graph.edges.systemd import unit_places
    from bringup_lint.graph.edges.systemd import user_edges

    graph.add(unit_edges(robot.units))
    graph.define(unit_places(robot.units, set(graph.nodes)))
    graph.ranks = boot_ranks(robot.units, [node for node in graph.nodes if node.kind in KINDS])
    graph.add(user_edges(robot.units))
    graph.add(environment_edges(robot))
    graph.define(environment_places(robot))
    graph.add(run_edges(robot))
    graph.define(script_places(robot))


def _add_services(graph: Graph, robot: Robot) -> None:
    if not robot.of_kind("compose"):
        return
    from bringup_lint.graph.edges.compose import compose_edges
    from bringup_lint.graph.edges.compose import compose_places
    from bringup_lint.graph.edges.compose import starting_units

    graph.add(compose_edges(robot))
    graph.define(compose_places(robot))
    if robot.of_kind(*UNITS):
        graph.add(starting_units(robot))


def _add_launch(graph: Graph, robot: Robot) -> None:
    if not robot.of_kind(*LAUNCH):
        return
    from bringup_lint.graph.edges.launch import launch_edges
    from bringup_lint.graph.edges.launch import launch_places

    graph.add(launch_edges(robot.launch))
    graph.define(launch_places(robot.launch))
    _try(_add_topics, graph, robot)


def _add_topics(graph: Graph, robot: Robot) -> None:
    from bringup_lint.graph.edges.topics import program_places
    from bringup_lint.graph.edges.topics import topic_edges

    graph.add(topic_edges(robot))
    graph.define(program_places(robot))


def _add_files(graph: Graph, robot: Robot) -> None:
    """Files that lines of other layers are looked up in, whoever reads them."""
    from bringup_lint.graph.file_nodes import file_node
    from bringup_lint.graph.file_nodes import file_place

    for source in robot.of_kind("params"):
        if source.judged:
            graph.define([(file_node("parameter-file", source), file_place(source))])
    for source in robot.of_kind("env-file"):
        if source.judged:
            graph.define([(file_node("env-file", source), file_place(source))])


def _add_network(graph: Graph, robot: Robot, places: Places) -> None:
    if not robot.of_kind("netplan"):
        return
    from bringup_lint.graph.edges.netplan import network_edges
    from bringup_lint.graph.edges.netplan import network_places

    graph.add(network_edges(robot))
    graph.define(network_places(robot))


def _add_dds(graph: Graph, robot: Robot, places: Places) -> None:
    from bringup_lint.graph.edges.dds import binding_edges
    from bringup_lint.graph.edges.dds import dds_places
    from bringup_lint.graph.edges.dds import selection_edges

    graph.define(dds_places(robot))
    graph.add(selection_edges(robot, places))
    graph.add(binding_edges(robot, places))


def _add_security(graph: Graph, robot: Robot, places: Places) -> None:
    from bringup_lint.graph.edges.sros2 import document_edges
    from bringup_lint.graph.edges.sros2 import keystore_edges
    from bringup_lint.graph.edges.sros2 import security_places

    graph.add(keystore_edges(robot, places))
    graph.add(document_edges(robot))
    graph.define(security_places(robot))


def _add_devices(graph: Graph, robot: Robot, places: Places) -> None:
    from bringup_lint.graph.edges.udev import device_edges
    from bringup_lint.graph.edges.udev import device_units
    from bringup_lint.graph.edges.udev import rule_edges
    from bringup_lint.graph.edges.udev import rule_places

    graph.add(device_edges(robot, places))
    graph.add(device_units(graph.nodes))
    graph.add(rule_edges(robot, graph.nodes))
    graph.define(rule_places(robot))
