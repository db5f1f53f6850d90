"""The picture in words, for screen readers, for print and for browsers without scripts."""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Mapping
from typing import Any

from bringup_lint.report.html.markup import text

Edges = dict[int, list[Mapping[str, Any]]]


def outline(data: Mapping[str, Any]) -> str:
    """For each layer the list of its nodes, each with its place and the edges that leave it."""
    leaving: Edges = defaultdict(list)
    for edge in data["edges"]:
        leaving[edge["source"]].append(edge)
    return "\n".join(_layer(layer, data, leaving) for layer in data["layers"])


def _layer(layer: Mapping[str, str], data: Mapping[str, Any], leaving: Edges) -> str:
    held = [number for number, node in enumerate(data["nodes"]) if node["layer"] == layer["id"]]
    held.sort(key=lambda number: (data["nodes"][number]["rank"] or 0, data["nodes"][number]["label"]))
    items = "".join(_node(number, data, leaving[number]) for number in held)
    return f"<section><h3>{text(layer['title'])}</h3><ul>{items}</ul></section>"


def _node(number: int, data: Mapping[str, Any], edges: list[Mapping[str, Any]]) -> str:
    node = data["nodes"][number]
    said = "".join(f"<li>{_edge(edge, data)}</li>" for edge in edges)
    found = "".join(f"<li>{_finding(data['findings'][index])}</li>" for index in node["findings"])
    below = f"<ul>{found}{said}</ul>" if found or said else ""
    return f"<li><b>{text(node['label'])}</b> {text(node['kind'])}{_place(node)}{below}</li>"


def _edge(edge: Mapping[str, Any], data: Mapping[str, Any]) -> str:
    why = f" ({text(edge['why'])})" if edge["why"] else ""
    return f"{text(edge['kind'])} {text(data['nodes'][edge['target']]['label'])}{why}{_place(edge)}"


def _finding(finding: Mapping[str, Any]) -> str:
    return f"{text(finding['severity'])}: {text(finding['message'])}"


def _place(item: Mapping[str, Any]) -> str:
    if not item["path"]:
        return ""
    line = f":{item['line']}" if item["line"] else ""
    return f' <span class="place">{text(item["path"])}{line}</span>'
