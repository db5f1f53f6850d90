"""The one graph of a robot: every layer, joined by the references that files make."""

from __future__ import annotations

from typing import TYPE_CHECKING

from bringup_lint.graph.graph import Graph

if TYPE_CHECKING:
    from bringup_lint.robot import Robot

UNITS = ("systemd-unit", "systemd-dropin")
LAUNCH = ("launch-python", "launch-xml", "launch-yaml")


def joined_graph(robot: Robot) -> Graph:
    """Everything that the files of the tree name. What they only share a repository with is not joined."""
    graph = Graph()
    if robot.of_kind(*UNITS):
        _add_units(graph, robot)
    if robot.of_kind(*LAUNCH):
        from bringup_lint.graph.launch.edges import launch_edges
        from bringup_lint.graph.launch.edges import launch_places

        graph.add(launch_edges(robot.launch))
        graph.define(launch_places(robot.launch))
    graph.out = {node: list(dict.fromkeys(edges)) for node, edges in graph.out.items()}
    graph.into = {node: list(dict.fromkeys(edges)) for node, edges in graph.into.items()}
    return graph


def _add_units(graph: Graph, robot: Robot) -> None:
    from bringup_lint.graph.environment.edges import environment_edges
    from bringup_lint.graph.environment.edges import environment_places
    from bringup_lint.graph.systemd.edges import KINDS
    from bringup_lint.graph.systemd.edges import unit_edges
    from bringup_lint.graph.systemd.edges import unit_places
    from bringup_lint.graph.systemd.edges import user_edges
    from bringup_lint.graph.systemd.ranks import boot_ranks
    from bringup_lint.graph.systemd.runs import run_edges
    from bringup_lint.graph.systemd.runs import script_places

    graph.add(unit_edges(robot.units))
    graph.define(unit_places(robot.units, set(graph.nodes)))
    graph.ranks = boot_ranks(robot.units, [node for node in graph.nodes if node.kind in KINDS])
    graph.add(user_edges(robot.units))
    graph.add(environment_edges(robot))
    graph.define(environment_places(robot))
    graph.add(run_edges(robot))
    graph.define(script_places(robot))
