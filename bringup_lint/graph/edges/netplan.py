"""Network interfaces as nodes: the netplan files that configure them, and the ones they are built on."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from bringup_lint.graph.file_nodes import file_node
from bringup_lint.graph.file_nodes import file_place
from bringup_lint.graph.graph import Edge
from bringup_lint.graph.graph import Node
from bringup_lint.graph.netplan.netplan import references
from bringup_lint.model.netplan import Interface
from bringup_lint.model.netplan import Plan
from bringup_lint.source import Span

if TYPE_CHECKING:
    from bringup_lint.model.netplan import Netplan


def interface_node(interface: Interface, plan: Plan, netplan: Netplan) -> Node:
    """By the name of the device where netplan fixes it, else by the netplan id."""
    place = "" if plan is netplan.only_plan else plan.files[0].source.name
    return Node("interface", str(interface.device or interface.name), place)


def network_edges(netplan: Netplan) -> Iterator[Edge]:
    """``configured-by`` to netplan files, and ``built-on`` from bridges, bonds and VLANs to their parts."""
    for plan, interface in _interfaces(netplan):
        here = interface_node(interface, plan, netplan)
        for definition in interface.definitions:
            target = file_node("netplan-file", definition.name.span.source)
            yield Edge("configured-by", here, target, definition.name.span, f"{definition.kind}:")
        for key, name in references(interface):
            other = plan.interfaces.get(str(name))
            if key in ("link", "interfaces") and other is not None and other is not interface:
                yield Edge("built-on", here, interface_node(other, plan, netplan), name.span, f"{key}:")


def network_places(netplan: Netplan) -> Iterator[tuple[Node, Span]]:
    for file in netplan.files:
        if file.source.judged:
            yield file_node("netplan-file", file.source), file_place(file.source)
    for plan, interface in _interfaces(netplan):
        for definition in interface.definitions:
            start = definition.name.span
            end = max(definition.body.span.end, start.end)
            yield interface_node(interface, plan, netplan), start._replace(end=end)


def _interfaces(netplan: Netplan) -> Iterator[tuple[Plan, Interface]]:
    for plan in netplan.plans:
        for interface in plan.interfaces.values():
            if interface.name.span.source.judged:
                yield plan, interface
