"""The one graph of a robot: every layer, joined by the references that files make."""

from __future__ import annotations

from collections.abc import Callable
from functools import partial
from typing import TYPE_CHECKING

from bringup_lint.dataclass import dataclass
from bringup_lint.discover.kinds.launch import LAUNCH
from bringup_lint.discover.starters import STARTING
from bringup_lint.graph.graph import Graph
from bringup_lint.graph.places import Places

if TYPE_CHECKING:
    from bringup_lint.graph.containers.compose import Compose
    from bringup_lint.graph.dds.dds import Dds
    from bringup_lint.graph.edges.topics import Joins
    from bringup_lint.graph.environment.ros import RosEnvironment
    from bringup_lint.graph.files import Files
    from bringup_lint.graph.host.devices import Devices
    from bringup_lint.graph.launch.launch import Launch
    from bringup_lint.graph.networkmanager.profiles import NetworkManager
    from bringup_lint.graph.params.params import Params
    from bringup_lint.graph.runners.runners import Runners
    from bringup_lint.graph.sros2.sros2 import Sros2
    from bringup_lint.graph.systemd.units import Units
    from bringup_lint.graph.udev.udev import Udev
    from bringup_lint.model.netplan import Netplan

UNITS = ("systemd-unit", "systemd-dropin")


@dataclass(frozen=True)
class Layers:
    """What is joined. Each layer is made when the first file of its kinds asks for it."""

    files: Files
    units: Callable[[], Units]
    runners: Callable[[], Runners]
    ros: Callable[[], RosEnvironment]
    compose: Callable[[], Compose]
    launch: Callable[[], Launch]
    params: Callable[[], Params]
    topic_joins: Callable[[], Joins]
    netplan: Callable[[], Netplan]
    networkmanager: Callable[[], NetworkManager]
    dds: Callable[[], Dds]
    sros2: Callable[[], Sros2]
    udev: Callable[[], Udev]
    devices: Callable[[], Devices]


def joined_graph(layers: Layers) -> Graph:
    """Everything that the files of the tree name. What they only share a repository with is not joined."""
    graph = Graph()
    for add in (_add_units, _add_services, _add_runners, _add_launch, _add_files):
        _try(add, graph, layers)
    places = Places(graph)
    for join in (_add_network, _add_dds, _add_security, _add_devices):
        _try(join, graph, layers, places)
    for ends in (graph.out, graph.into):
        for node, edges in ends.items():
            if len(edges) > 1:
                ends[node] = list(dict.fromkeys(edges))
    return graph


def _try(add: Callable[..., None], graph: Graph, layers: Layers, *more: Places) -> None:
    """A layer that fails costs itself alone."""
    try:
        add(graph, layers, *more)
    except Exception as error:
        graph.failures.append(error)


def _add_units(graph: Graph, layers: Layers) -> None:
    if not layers.files.of_kind(*UNITS):
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

    graph.add(unit_edges(layers.units()))
    graph.define(unit_places(layers.units(), set(graph.nodes)))
    graph.rank = partial(boot_ranks, layers.units(), [node for node in graph.nodes if node.kind in KINDS])
    graph.add(user_edges(layers.units()))
    graph.add(environment_edges(layers.units()))
    graph.define(environment_places(layers.units()))
    graph.add(run_edges(layers.files.tree, layers.units(), layers.launch))
    graph.define(script_places(layers.files.tree, layers.units()))


def _add_services(graph: Graph, layers: Layers) -> None:
    if not layers.files.of_kind("compose"):
        return
    from bringup_lint.graph.edges.compose import compose_edges
    from bringup_lint.graph.edges.compose import compose_places
    from bringup_lint.graph.edges.compose import starting_units

    graph.add(compose_edges(layers.files.tree, layers.compose(), layers.runners()))
    graph.define(compose_places(layers.compose()))
    if layers.files.of_kind(*UNITS):
        graph.add(starting_units(layers.files.tree, layers.compose(), layers.units()))


def _add_runners(graph: Graph, layers: Layers) -> None:
    if not layers.files.of_kind(*STARTING):
        return
    from bringup_lint.graph.edges.runners import runner_edges
    from bringup_lint.graph.edges.runners import runner_places

    graph.add(runner_edges(layers.runners(), layers.launch))
    graph.define(runner_places(layers.runners()))


def _add_launch(graph: Graph, layers: Layers) -> None:
    if not layers.files.of_kind(*LAUNCH):
        return
    from bringup_lint.graph.edges.launch import launch_edges
    from bringup_lint.graph.edges.launch import launch_places

    graph.add(launch_edges(layers.files.tree, layers.launch()))
    graph.define(launch_places(layers.launch()))
    _try(_add_topics, graph, layers)


def _add_topics(graph: Graph, layers: Layers) -> None:
    joins = layers.topic_joins()
    graph.add(joins.edges)
    graph.define(joins.places)


def _add_files(graph: Graph, layers: Layers) -> None:
    """Files that lines of other layers are looked up in, whoever reads them."""
    from bringup_lint.graph.file_nodes import file_node
    from bringup_lint.graph.file_nodes import file_place

    for source in layers.files.of_kind("params"):
        if source.judged:
            graph.define([(file_node("parameter-file", source), file_place(source))])
    for source in layers.files.of_kind("env-file"):
        if source.judged:
            graph.define([(file_node("env-file", source), file_place(source))])


def _add_network(graph: Graph, layers: Layers, places: Places) -> None:
    if layers.files.of_kind("netplan"):
        from bringup_lint.graph.edges.netplan import network_edges
        from bringup_lint.graph.edges.netplan import network_places

        graph.add(network_edges(layers.netplan()))
        graph.define(network_places(layers.netplan()))
    if layers.files.of_kind("networkmanager"):
        from bringup_lint.graph.edges.networkmanager import profile_edges
        from bringup_lint.graph.edges.networkmanager import profile_places

        graph.add(profile_edges(layers.networkmanager()))
        graph.define(profile_places(layers.networkmanager()))


def _add_dds(graph: Graph, layers: Layers, places: Places) -> None:
    from bringup_lint.graph.edges.dds import binding_edges
    from bringup_lint.graph.edges.dds import dds_places
    from bringup_lint.graph.edges.dds import selection_edges

    graph.define(dds_places(layers.files))
    graph.add(selection_edges(layers.files.tree, layers.dds(), layers.ros(), places))
    graph.add(binding_edges(layers.dds(), layers.netplan, layers.networkmanager, places))


def _add_security(graph: Graph, layers: Layers, places: Places) -> None:
    from bringup_lint.graph.edges.sros2 import document_edges
    from bringup_lint.graph.edges.sros2 import keystore_edges
    from bringup_lint.graph.edges.sros2 import security_places

    graph.add(keystore_edges(layers.files, layers.sros2(), layers.ros(), places))
    graph.add(document_edges(layers.sros2()))
    graph.define(security_places(layers.files, layers.sros2()))


def _add_devices(graph: Graph, layers: Layers, places: Places) -> None:
    from bringup_lint.graph.edges.udev import device_edges
    from bringup_lint.graph.edges.udev import device_units
    from bringup_lint.graph.edges.udev import rule_edges
    from bringup_lint.graph.edges.udev import rule_places

    graph.add(device_edges(layers.devices(), layers.params, places))
    graph.add(device_units(graph.nodes))
    graph.add(rule_edges(layers.udev(), graph.nodes))
    graph.define(rule_places(layers.udev()))
