"""What nodes of the picture are called: short, and different from one another."""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Iterable

from bringup_lint.graph.graph import Graph
from bringup_lint.graph.graph import Node


def labels(graph: Graph) -> dict[Node, str]:
    """Files and folders of the tree by the shortest end of their path that tells them apart, all else by its name."""
    found = {node: node.name for node in graph.nodes}
    files: dict[str, list[Node]] = defaultdict(list)
    for node in found:
        places = graph.places.get(node)
        if places and f"{places[0].path}/".startswith(f"{node.name}/"):
            files[node.kind].append(node)
    for nodes in files.values():
        tails = shortest_tails({node.name for node in nodes})
        found.update((node, tails[node.name]) for node in nodes)
    _tell_apart(found)
    return found


def _tell_apart(found: dict[Node, str]) -> None:
    """The file goes with names that several nodes of a kind have."""
    same: dict[tuple[str, str], list[Node]] = defaultdict(list)
    for node, label in found.items():
        same[node.kind, label].append(node)
    for nodes in same.values():
        if len(nodes) > 1:
            tails = shortest_tails({node.place for node in nodes if node.place})
            found.update((node, f"{found[node]} ({tails[node.place]})") for node in nodes if node.place)


def shortest_tails(paths: Iterable[str]) -> dict[str, str]:
    """Each path's last components, as few as tell it from the others."""
    found: dict[str, str] = {}
    pending, count = set(paths), 1
    while pending:
        by_tail: dict[str, list[str]] = defaultdict(list)
        for path in pending:
            by_tail["/".join(path.split("/")[-count:])].append(path)
        for tail, same in by_tail.items():
            if len(same) == 1 or all(path.count("/") < count for path in same):
                found.update((path, tail) for path in same)
        pending -= found.keys()
        count += 1
    return found
