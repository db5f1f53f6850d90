"""Subscriptions that ask PX4 for a reliability which it does not offer."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from bringup_lint.pattern import regex

if TYPE_CHECKING:
    from bringup_lint.graph.nodes.nodes import Nodes
    from bringup_lint.model.node_source import Endpoint
    from bringup_lint.source import Source

_PUBLISHED = regex(r"(?:.*/)?fmu/out/\w+\Z")
"""What uxrce_dds_client of PX4 publishes, all of it best effort. Source: PX4 guide, "PX4 ROS 2 QoS Settings"."""


def too_reliable(nodes: Nodes) -> Iterator[tuple[Source, list[Endpoint]]]:
    """The subscriptions of a source to which PX4 sends nothing. Left out are topics that a node of the tree publishes
    in place of PX4."""
    sources = list(_endpoints(nodes))
    simulated = {each.name for _, endpoints in sources for each in endpoints if each.role == "publisher"}
    for source, endpoints in sources:
        found = [each for each in endpoints if _asks_too_much(each) and each.name not in simulated]
        if found:
            yield source, found


def _endpoints(nodes: Nodes) -> Iterator[tuple[Source, list[Endpoint]]]:
    for _, node in nodes.node_classes:
        yield node.source, node.endpoints
    for source in nodes.cpp:
        yield source.source, source.endpoints


def _asks_too_much(endpoint: Endpoint) -> bool:
    if endpoint.role != "subscription" or endpoint.name is None or endpoint.qos is None:
        return False
    return endpoint.qos.reliability == "RELIABLE" and bool(_PUBLISHED.match(endpoint.name))
