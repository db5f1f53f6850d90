"""``bringup-lint graph``: one graph of all layers, and its picture in every format."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

from tests.conftest import PROJECT
from tests.lint import lint

ROBOTS = PROJECT / "fixtures/robots"


def drawn(folder: Path, *arguments: str) -> dict[str, Any]:
    run = lint("graph", "--format", "json", *arguments, cwd=folder)
    assert run.code == 0, run.stderr
    return json.loads(run.stdout)


def said(document: dict[str, Any]) -> set[tuple[str, str, str]]:
    labels = {node["id"]: node["label"] for node in document["nodes"]}
    return {(labels[edge["source"]], edge["kind"], labels[edge["target"]]) for edge in document["edges"]}


def tree(folder: Path, files: dict[str, str]) -> Path:
    for name, text in files.items():
        (folder / name).parent.mkdir(parents=True, exist_ok=True)
        (folder / name).write_text(text)
    return folder


def test_guide_robot_is_joined_from_power_on_to_its_nodes() -> None:
    edges = said(drawn(ROBOTS / "guide/tree", "--root", "."))
    assert {
        ("network-online.target", "orders", "heron-drivers.service"),
        ("heron-drivers.service", "runs-as", "heron"),
        ("heron-drivers.service", "loads-env", "ros.env"),
        ("heron-drivers.service", "runs", "drivers.launch.py"),
        ("drivers.launch.py", "starts", "/lidar"),
        ("stack.launch.py", "includes", "drivers.launch.py"),
        ("/uploader", "loads-params", "uploads.yaml"),
    } <= edges


def test_units_of_the_distribution_are_drawn_only_when_the_tree_names_them(tmp_path: Path) -> None:
    tree(tmp_path, {"a.service": "[Unit]\nAfter=network-online.target\n[Service]\nExecStart=/bin/true\n"})
    nodes = {node["id"]: node for node in drawn(tmp_path)["nodes"]}
    assert set(nodes) == {"unit:a.service", "unit:network-online.target", "program:/bin/true"}
    assert nodes["unit:network-online.target"]["rank"] < nodes["unit:a.service"]["rank"]
    assert (nodes["unit:a.service"]["path"], nodes["unit:a.service"]["line"]) == ("a.service", 1)
    assert nodes["unit:network-online.target"]["path"] is None


def test_findings_stand_on_their_nodes_and_edges(tmp_path: Path) -> None:
    unit = "[Unit]\nAfter={}.service\n[Service]\nExecStart=/bin/true\n[Install]\nWantedBy=multi-user.target\n"
    tree(tmp_path, {"a.service": unit.format("b"), "b.service": unit.format("a")})
    document = drawn(tmp_path)
    rules = [finding["rule"] for finding in document["findings"]]
    (index,) = [at for at, rule in enumerate(rules) if rule == "systemd/ordering-cycle"]
    assert [node["id"] for node in document["nodes"] if index in node["findings"]] == ["unit:a.service"]
    cycle = [edge for edge in document["edges"] if edge["why"] == "After="]
    assert [index in edge["findings"] for edge in cycle] == [True, True]
