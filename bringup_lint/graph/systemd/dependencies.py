"""Requirement and ordering edges between units, as units write them; the implicit ones and the
distribution's are added."""

from __future__ import annotations

from collections.abc import Iterator

from bringup_lint.graph.graph import Edge
from bringup_lint.graph.graph import Graph
from bringup_lint.graph.systemd.distribution import distribution_edges
from bringup_lint.graph.systemd.implicit import after_members
from bringup_lint.graph.systemd.implicit import implicit_edges
from bringup_lint.graph.systemd.named_units import NamedUnits
from bringup_lint.graph.systemd.references import Instance
from bringup_lint.graph.systemd.references import instances
from bringup_lint.graph.systemd.references import resolve
from bringup_lint.graph.systemd.references import targets
from bringup_lint.graph.systemd.relations import INSTALLED
from bringup_lint.graph.systemd.relations import OTHER
from bringup_lint.graph.systemd.relations import PULLS
from bringup_lint.graph.systemd.unit import Unit
from bringup_lint.graph.systemd.unit_loading import Link


def dependency_graph(stated: Graph, units: NamedUnits) -> Graph:
    """All edges between units that the tree or the distribution states. Those of the tree, which are ``stated``, come
    first at each unit."""
    graph = stated.copy()
    if not units.has_vendor_units:
        graph.add(distribution_edges(units.all, units.files.target.systemd))
    graph.add(list(after_members(graph, units)))
    return graph


def stated_graph(units: NamedUnits) -> Graph:
    """The edges that the units and links of the tree state, with what follows from the type and the settings of a
    unit."""
    graph = Graph()
    graph.add(_stated(units))
    return graph


def _stated(units: NamedUnits) -> Iterator[Edge]:
    for instance in instances(units):
        yield from _written(instance, units)
        if instance.unit.fragment is not None:
            yield from implicit_edges(instance, units)
    for link in units.links:
        yield from _linked(link, units)


def _written(instance: Instance, units: NamedUnits) -> Iterator[Edge]:
    unit, here = instance.unit, instance.node
    for key, kind in (PULLS | OTHER).items():
        for there, span in targets(instance, units, unit.words(key)):
            yield Edge(kind, here, there, span, f"{key}=")
    for there, span in targets(instance, units, unit.words("After")):
        yield Edge("orders", there, here, span, "After=")
    for there, span in targets(instance, units, unit.words("Before")):
        yield Edge("orders", here, there, span, "Before=")
    if not units.installs(unit):
        return
    for key, kind in INSTALLED.items():
        for there, span in targets(instance, units, unit.words(key, "Install")):
            yield Edge(kind, there, here, span, f"{key}=")


def _linked(link: Link, units: NamedUnits) -> Iterator[Edge]:
    near = Unit(link.unit, link.manager, place=link.place)
    here, there = resolve(link.unit, near, units), resolve(link.name, near, units)
    if here and there:
        kind = PULLS[link.relation]
        where = link.source.whole if link.source.judged else None
        yield Edge(kind, here, there, where, f".{kind} link")
