"""What a drawing shows of the edges: one arrow between two nodes, whatever they have to do with each other."""

from __future__ import annotations

from collections import defaultdict
from itertools import pairwise
from math import isqrt
from typing import Any

from bringup_lint.named_tuple import NamedTuple

Edge = dict[str, Any]

NEEDS = frozenset({"requires", "requisite", "binds-to", "wants", "upholds", "part-of", "conflicts"})
"""Kinds that point from a unit to what it needs, which starts no later when there is an order at all."""
STRONG = frozenset({"requires", "requisite", "binds-to"})
WEAK = frozenset({"wants", "upholds", "part-of", "conflicts", "names", "runs-as"})
SEVERITIES = ("info", "warning", "error")
LONGEST = 44
"""Characters of a label."""


class Arrow(NamedTuple):
    source: str
    target: str
    label: str
    weight: str
    """``strong``, ``plain`` or ``weak``."""
    orders: bool
    """Whether the source comes before the target."""
    findings: tuple[int, ...]


def arrows(document: dict[str, Any]) -> list[Arrow]:
    """In the direction of time where an order is known: from power-on to the last topic."""
    pairs: dict[tuple[str, str], list[Edge]] = defaultdict(list)
    for edge in document["edges"]:
        pairs[_ends(edge)].append(edge)
    return [arrow for ends, edges in _merged(pairs) for arrow in _arrows(ends, edges)]


def _ends(edge: Edge) -> tuple[str, str]:
    if edge["kind"] == "subscribes":
        return edge["target"], edge["source"]
    return edge["source"], edge["target"]


def _merged(pairs: dict[tuple[str, str], list[Edge]]) -> list[tuple[tuple[str, str], list[Edge]]]:
    """What a unit needs goes with the order of the two, when that points the other way."""
    merged = dict(pairs)
    for ends, edges in pairs.items():
        back = merged.get(ends[::-1])
        if back and all(edge["kind"] in NEEDS for edge in edges) and any(edge["kind"] == "orders" for edge in back):
            merged[ends[::-1]] = back + edges
            del merged[ends]
    return list(merged.items())


def _arrows(ends: tuple[str, str], edges: list[Edge]) -> list[Arrow]:
    kinds = {edge["kind"] for edge in edges}
    weight = "strong" if kinds & STRONG else "weak" if kinds <= WEAK else "plain"
    findings = sorted({index for edge in edges for index in edge["findings"]})
    return [Arrow(*ends, _label(edges), weight, not kinds <= NEEDS, tuple(findings))]


def _label(edges: list[Edge]) -> str:
    words = dict.fromkeys(_word(edge) for edge in edges)
    return shortened(", ".join(word for word in words if word))


def _word(edge: Edge) -> str:
    """The setting for what units say of each other, the kind of everything else, with its condition."""
    kind, condition = str(edge["kind"]), str(edge["condition"])
    if kind in NEEDS or kind == "orders":
        return str(edge["why"]) if edge["origin"] == "setting" else ""
    return f"{kind} ({condition})" if condition else kind


def shortened(text: str, longest: int = LONGEST) -> str:
    """The beginning of a text, the end of a path."""
    if len(text) <= longest:
        return text
    return f"…{text[1 - longest :]}" if text.startswith("/") else f"{text[: longest - 1]}…"


def rows(document: dict[str, Any]) -> list[tuple[str, str]]:
    """Pairs of nodes that nothing leads to or from, to be drawn side by side: else all of a layer form one column."""
    busy = {end for edge in document["edges"] for end in (edge["source"], edge["target"])}
    alone: dict[str, list[str]] = defaultdict(list)
    for node in document["nodes"]:
        if node["id"] not in busy:
            alone[node["layer"]].append(node["id"])
    pairs = []
    for ids in alone.values():
        width = isqrt(len(ids) // 3) + 1
        pairs += [pair for at, pair in enumerate(pairwise(ids), 1) if at % width]
    return pairs


def worst(document: dict[str, Any], findings: list[int] | tuple[int, ...]) -> str:
    """The highest severity of some findings; empty when there are none."""
    found = {document["findings"][index]["severity"] for index in findings}
    return next((severity for severity in reversed(SEVERITIES) if severity in found), "")
