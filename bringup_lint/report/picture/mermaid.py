"""The picture as a Mermaid flowchart: a subgraph for each layer, from left to right as the robot comes up."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

from bringup_lint.pattern import regex
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
    "unit": ("(", ")"),
    "user-unit": ("(", ")"),
    "compose-service": ("[[", "]]"),
    "ros-node": ("([", "])"),
    "process": ("([", "])"),
    "program": ("([", "])"),
    "device": (">", "]"),
    "topic": ("[/", "/]"),
    "enclave": ("{{", "}}"),
    "keystore": ("{{", "}}"),
}
"""Files are boxes."""
LONGEST = 48
"""Characters of a label."""
_LINES = {"strong": "==>", "plain": "-->", "weak": "-.->"}
_ODD = regex("[^A-Za-z0-9 _./,:()@=✖▲●…-]")


def render(document: dict[str, Any]) -> str:
    return "\n".join(_lines(sound(document))) + "\n"


def _lines(document: dict[str, Any]) -> Iterator[str]:
    yield "flowchart LR"
    names = {node["id"]: f"n{at}" for at, node in enumerate(document["nodes"])}
    for layer in document["layers"]:
        members = [node for node in document["nodes"] if node["layer"] == layer["id"]]
        if members:
            yield f"  subgraph layer-{layer['id']} [{quoted(layer['title'])}]"
            yield from (f"    {names[node['id']]}{_node(document, node)}" for node in members)
            yield "  end"
    drawn = arrows(document)
    yield from (f"  {_arrow(document, arrow, names)}" for arrow in drawn)
    yield from (f"  {names[one]} ~~~ {names[other]}" for one, other in rows(document))
    yield from _styles(document, names)
    for at, arrow in enumerate(drawn):
        severity = worst(document, arrow.findings)
        if severity:
            yield f"  linkStyle {at} stroke:{STROKES[severity]},color:{STROKES[severity]}"


def _node(document: dict[str, Any], node: dict[str, Any]) -> str:
    lines = marked(shortened(node["label"], LONGEST), worst(document, node["findings"]), len(node["findings"]))
    opening, closing = SHAPES.get(node["kind"], ("[", "]"))
    return f"{opening}{quoted(*lines)}{closing}"


def _arrow(document: dict[str, Any], arrow: Arrow, names: dict[str, str]) -> str:
    severity = worst(document, arrow.findings)
    label = f"{SIGNS[severity]} {arrow.label}".strip() if severity else arrow.label
    text = f"|{quoted(label)}| " if label else " "
    return f"{names[arrow.source]} {_LINES[arrow.weight]}{text}{names[arrow.target]}"


def _styles(document: dict[str, Any], names: dict[str, str]) -> Iterator[str]:
    """Classes for layers, for what the tree does not hold, and for findings."""
    shown = {node["layer"] for node in document["nodes"]}
    classes = {"layer": [f"layer-{layer['id']}" for layer in document["layers"] if layer["id"] in shown]}
    for node in document["nodes"]:
        absent = node["path"] is None and node["kind"] not in ALWAYS_WHOLE
        classes.setdefault("absent" if absent else node["layer"], []).append(names[node["id"]])
        severity = worst(document, node["findings"])
        if severity:
            classes.setdefault(severity, []).append(names[node["id"]])
        if node["id"] in document["focus"]:
            classes.setdefault("focus", []).append(names[node["id"]])
    for name, style in _CLASSES.items():
        if classes.get(name):
            yield f"  classDef {name} {style}"
            yield f"  class {','.join(classes[name])} {name}"


_CLASSES = {
    "layer": f"fill:none,stroke:{STROKES['']}",
    **{layer: f"fill:{fill},stroke:{STROKES['']},color:{TEXT}" for layer, fill in FILLS.items()},
    "absent": f"fill:#ffffff,stroke:{STROKES['']},color:{TEXT},stroke-dasharray:4 3",
    "focus": "stroke-width:4px",
    **{name: f"stroke:{STROKES[name]},stroke-width:3px" for name in ("info", "warning", "error")},
}


def quoted(*lines: str) -> str:
    """A label that Mermaid shows as it is, whatever it holds: odd characters by their number."""
    return '"' + "<br/>".join(_ODD.sub(lambda match: f"#{ord(match[0])};", line) for line in lines) + '"'
