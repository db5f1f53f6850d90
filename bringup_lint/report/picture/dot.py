"""The picture for Graphviz: a cluster for each layer, from left to right as the robot comes up."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

from bringup_lint.report.picture.arrows import Arrow
from bringup_lint.report.picture.arrows import arrows
from bringup_lint.report.picture.arrows import rows
from bringup_lint.report.picture.arrows import shortened
from bringup_lint.report.picture.arrows import worst
from bringup_lint.report.picture.marks import ALWAYS_WHOLE
from bringup_lint.report.picture.marks import FILLS
from bringup_lint.report.picture.marks import SIGNS
from bringup_lint.report.picture.marks import STROKES
from bringup_lint.report.picture.marks import TEXT
from bringup_lint.report.picture.marks import marked
from bringup_lint.report.unicode import sound

SHAPES = {
    "unit": "box",
    "user-unit": "box",
    "compose-service": "box3d",
    "user": "house",
    "ros-node": "ellipse",
    "process": "ellipse",
    "program": "ellipse",
    "interface": "component",
    "device": "cds",
    "topic": "parallelogram",
    "enclave": "octagon",
    "keystore": "folder",
    "udev-rule": "note",
}
"""Files are notes."""
LONGEST = 48
"""Characters of a label."""
FONT = f'fontname="Helvetica,Arial,sans-serif", fontcolor="{TEXT}"'
_BORDERS = {"error": "3", "warning": "2"}
_WEIGHTS = {"strong": "penwidth=1.8", "plain": "penwidth=1", "weak": "style=dashed"}


def render(document: dict[str, Any]) -> str:
    return "\n".join(_lines(sound(document))) + "\n"


def _lines(document: dict[str, Any]) -> Iterator[str]:
    yield "digraph robot {"
    yield f"  graph [rankdir=LR, nodesep=0.2, ranksep=0.7, {FONT}];"
    yield f"  node [style=filled, fontsize=11, {FONT}];"
    yield f'  edge [color="{STROKES[""]}", fontsize=8, {FONT}, fontcolor="{STROKES[""]}"];'
    for layer in document["layers"]:
        members = [node for node in document["nodes"] if node["layer"] == layer["id"]]
        if members:
            yield f"  subgraph {quoted('cluster_' + layer['id'])} {{"
            yield f'    label={quoted(layer["title"])}; style="rounded"; color="#9aa0a6"; fontsize=14;'
            yield from (f"    {_node(document, node)}" for node in members)
            yield "  }"
    yield from (f"  {_arrow(document, arrow)}" for arrow in arrows(document))
    yield from (f"  {quoted(one)} -> {quoted(other)} [style=invis];" for one, other in rows(document))
    yield "}"


def _node(document: dict[str, Any], node: dict[str, Any]) -> str:
    severity = worst(document, node["findings"])
    lines = marked(shortened(node["label"], LONGEST), severity, len(node["findings"]))
    absent = node["path"] is None and node["kind"] not in ALWAYS_WHOLE
    style = "filled,dashed" if absent else "filled"
    attributes = {
        "label": "\n".join(lines),
        "shape": SHAPES.get(node["kind"], "note"),
        "style": f"{style},rounded" if SHAPES.get(node["kind"]) == "box" else style,
        "fillcolor": "#ffffff" if absent else FILLS[node["layer"]],
        "color": STROKES[severity],
        "penwidth": _BORDERS.get(severity, "1"),
        "tooltip": "\n".join(_tooltip(document, node)),
    }
    if attributes["shape"] == "cds":
        attributes["margin"] = "0.25,0.08"
    if node["id"] in document["focus"]:
        attributes["peripheries"] = "2"
    return f"{quoted(node['id'])} [{', '.join(f'{name}={quoted(value)}' for name, value in attributes.items())}];"


def _tooltip(document: dict[str, Any], node: dict[str, Any]) -> Iterator[str]:
    where = f"{node['path']}:{node['line']}" if node["path"] else "not in the tree"
    yield f"{node['kind']} {node['label']} ({where})"
    for index in node["findings"]:
        finding = document["findings"][index]
        yield f"{finding['severity']}: {finding['message']} [{finding['rule']}]"


def _arrow(document: dict[str, Any], arrow: Arrow) -> str:
    severity = worst(document, arrow.findings)
    label = f"{SIGNS[severity]} {arrow.label}" if severity else arrow.label
    attributes = [f"label={quoted(label)}"] if label else []
    attributes.append(_WEIGHTS[arrow.weight])
    if severity:
        attributes += [f'color="{STROKES[severity]}"', f'fontcolor="{STROKES[severity]}"']
    if not arrow.orders:
        attributes.append("constraint=false")
    return f"{quoted(arrow.source)} -> {quoted(arrow.target)} [{', '.join(attributes)}];"


def quoted(text: str) -> str:
    """A string that Graphviz shows as it is: it reads backslashes as escapes, and ``&`` as the start of an entity."""
    shown = (
        character if character.isprintable() or character == "\n" else "\N{REPLACEMENT CHARACTER}" for character in text
    )
    escaped = "".join(shown).replace("\\", "\\\\").replace('"', '\\"').replace("&", "&amp;").replace("\n", "\\n")
    return f'"{escaped}"'
