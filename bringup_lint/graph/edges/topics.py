"""What topics add to the robot's graph: which node publishes and which subscribes what."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from bringup_lint.graph.edges.launch import ros_node
from bringup_lint.graph.file_nodes import file_place
from bringup_lint.graph.graph import Edge
from bringup_lint.graph.graph import Node
from bringup_lint.named_tuple import NamedTuple
from bringup_lint.source import Span

if TYPE_CHECKING:
    from bringup_lint.graph.launch.launch import Launch
    from bringup_lint.graph.topics.topics import Topics


class Joins(NamedTuple):
    """All that topics add, without the syntax of nodes from which they know it."""

    edges: list[Edge]
    places: list[tuple[Node, Span]]


KINDS = {"publisher": "publishes", "subscription": "subscribes"}


def joins_of(launch: Launch, topics: Topics) -> Joins:
    """What topics add to the nodes that launch files start."""
    return Joins(list(topic_edges(topics)), list(program_places(launch, topics)))


def topic_edges(topics: Topics) -> Iterator[Edge]:
    """``publishes`` and ``subscribes``, from the nodes that the launch layer's edges start to topics. One that only the
    table of known nodes tells has the node in the launch file as its place."""
    seen = set()
    for running in topics.entries:
        for node in running.nodes:
            for use in node.uses:
                edge = Edge(
                    KINDS[use.role], ros_node(node.started), Node("topic", use.topic), use.where, use.type or use.role
                )
                if edge not in seen:
                    seen.add(edge)
                    yield edge


def program_places(launch: Launch, topics: Topics) -> Iterator[tuple[Node, Span]]:
    """The sources of the nodes that launch files start, where the tree holds them."""
    for expansion in launch.entries:
        for started in expansion.nodes:
            code = topics.code(started) if started.is_node else None
            if code is not None and code.source is not None:
                yield ros_node(started), file_place(code.source)
