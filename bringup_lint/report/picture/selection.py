"""A part of the picture: what leads to some nodes and what they lead to, or some of its layers."""

from __future__ import annotations

import difflib
from collections.abc import Callable
from collections.abc import Collection
from collections.abc import Iterable
from collections.abc import Set as AbstractSet
from typing import Any

from bringup_lint.report.picture.arrows import arrows

Document = dict[str, Any]
Node = dict[str, Any]


class NothingFound(LookupError):
    """No node of the picture is called so."""


def focused(document: Document, names: Iterable[str], depth: int | None = None) -> Document:
    """The nodes of these names with everything on the ways to them and from them, at most ``depth`` steps away.

    Raises NothingFound.
    """
    import networkx

    graph = networkx.DiGraph((arrow.source, arrow.target) for arrow in arrows(document))
    graph.add_nodes_from(node["id"] for node in document["nodes"])
    centres = {node["id"] for name in names for node in named(document, name)}
    kept = set(centres)
    for centre in centres:
        for directed in (graph, graph.reverse(copy=False)):
            kept.update(networkx.single_source_shortest_path_length(directed, centre, cutoff=depth))
    return {**_part(document, lambda node: node["id"] in kept), "focus": sorted(centres)}


def around(document: Document, ids: AbstractSet[str]) -> Document:
    """The nodes of these ids, and those that one arrow ties to them."""
    ties = [(arrow.source, arrow.target) for arrow in arrows(document)]
    kept = {end for tie in ties for end in tie if not ids.isdisjoint(tie)} | set(ids)
    return _part(document, lambda node: node["id"] in kept)


def in_layers(document: Document, layers: Collection[str]) -> Document:
    return _part(document, lambda node: node["layer"] in layers)


def named(document: Document, name: str) -> list[Node]:
    """The nodes of an id, a label or a file; else those whose label or path ends so. Raises NothingFound."""
    wanted = name.removeprefix("./")
    tests: tuple[Callable[[Node], bool], ...] = (
        lambda node: node["id"] == wanted,
        lambda node: node["label"] == wanted,
        lambda node: node["label"].partition(" (")[0] == wanted,
        lambda node: node["path"] == wanted,
        lambda node: f"/{node['path'] or ''}".endswith(f"/{wanted}") or node["label"].endswith(f"/{wanted}"),
        lambda node: node["label"].rpartition(".")[0] == wanted,
    )
    for test in tests:
        found = [node for node in document["nodes"] if test(node)]
        if found:
            return found
    known = {text for node in document["nodes"] for text in (node["label"], node["id"])}
    near = difflib.get_close_matches(name, sorted(known), 1, 0.5)
    raise NothingFound(f"nothing in the picture is called '{name}'" + (f"; did you mean '{near[0]}'?" if near else ""))


def _part(document: Document, keep: Callable[[Node], bool]) -> Document:
    """The nodes that are kept, the edges between them, and their findings under new numbers."""
    nodes = [node for node in document["nodes"] if keep(node)]
    ids = {node["id"] for node in nodes}
    edges = [edge for edge in document["edges"] if edge["source"] in ids and edge["target"] in ids]
    used = sorted({index for each in (*nodes, *edges) for index in each["findings"]})
    number = {index: at for at, index in enumerate(used)}
    nodes, edges = (
        [{**each, "findings": [number[index] for index in each["findings"]]} for each in kept]
        for kept in (nodes, edges)
    )
    return {
        **document,
        "focus": [name for name in document["focus"] if name in ids],
        "nodes": nodes,
        "edges": edges,
        "findings": [document["findings"][index] for index in used],
    }
