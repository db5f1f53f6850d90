"""``bringup-lint graph``: what is drawn, which part of it, and in which format."""

from __future__ import annotations

import json
from pathlib import Path

import pytest

from bringup_lint.graph import layers
from tests.conftest import PROJECT
from tests.drawing import ROBOTS
from tests.drawing import check
from tests.drawing import drawn
from tests.drawing import said
from tests.drawing import tree
from tests.lint import lint


def test_findings_stand_on_their_nodes_and_edges(tmp_path: Path) -> None:
    unit = "[Unit]\nAfter={}.service\n[Service]\nExecStart=/bin/true\n[Install]\nWantedBy=multi-user.target\n"
    tree(tmp_path, {"a.service": unit.format("b"), "b.service": unit.format("a")})
    document = drawn(tmp_path)
    rules = [finding["rule"] for finding in document["findings"]]
    (index,) = [at for at, rule in enumerate(rules) if rule == "systemd/ordering-cycle"]
    assert [node["id"] for node in document["nodes"] if index in node["findings"]] == ["unit:a.service"]
    cycle = [edge for edge in document["edges"] if edge["why"] == "After="]
    assert [index in edge["findings"] for edge in cycle] == [True, True]


@pytest.mark.parametrize("robot", ["good", "guide"])
def test_published_schema_describes_the_picture(robot: str) -> None:
    check(drawn(ROBOTS / robot / "tree", "--root", "."))


def test_schema_names_every_kind_of_node() -> None:
    schema = json.loads((PROJECT / "docs/graph.schema.json").read_text("utf-8"))
    assert set(schema["$defs"]["node"]["properties"]["kind"]["enum"]) == set(layers._OF_NODE)
    assert schema["$defs"]["layer"]["enum"] == list(layers.LAYERS)


def test_focus_shows_what_leads_to_a_node_and_what_it_leads_to() -> None:
    document = drawn(ROBOTS / "good/tree", "--root", ".", "--focus", "lidar.yaml")
    labels = {node["label"] for node in document["nodes"]}
    assert {"tern-drivers.service", "drivers.launch.py", "/lidar", "lidar.yaml", "/dev/tern/lidar"} <= labels
    assert not {"tern-navigation.service", "ros.env", "/cloud", "multi-user.target"} & labels
    assert [name.rpartition("/")[2] for name in document["focus"]] == ["lidar.yaml"]
    check(document)


@pytest.mark.parametrize(
    ("name", "expected"),
    [
        ("unit:tern-drivers.service", "unit:tern-drivers.service"),
        ("tern-drivers.service", "unit:tern-drivers.service"),
        ("tern-drivers", "unit:tern-drivers.service"),
        ("./etc/tern/ros.env", "env-file:etc/tern/ros.env"),
        ("tern/ros.env", "env-file:etc/tern/ros.env"),
        ("/dev/tern/lidar", "device:/dev/tern/lidar"),
        ("etc/netplan/60-tern.yaml", "netplan-file:etc/netplan/60-tern.yaml"),
    ],
)
def test_focus_takes_ids_labels_and_ends_of_paths(name: str, expected: str) -> None:
    document = drawn(ROBOTS / "good/tree", "--root", ".", "--focus", name, "--depth", "0")
    assert expected in {node["id"] for node in document["nodes"]}
    assert {node["id"] for node in document["nodes"]} == set(document["focus"])


def test_depth_ends_the_ways(tmp_path: Path) -> None:
    unit = "[Unit]\nAfter={}.service\n[Service]\nExecStart=/bin/true\n"
    tree(tmp_path, {f"{name}.service": unit.format(before) for before, name in zip("abcd", "bcde", strict=True)})
    units = [node["label"] for node in drawn(tmp_path, "--focus", "c", "--depth", "1", "--layer", "boot")["nodes"]]
    assert units == ["/bin/true", "b.service", "c.service", "d.service"]


def test_layers(tmp_path: Path) -> None:
    document = drawn(ROBOTS / "guide/tree", "--root", ".", "--layer", "dds", "--layer", "network")
    assert {node["layer"] for node in document["nodes"]} == {"dds", "network"}
    assert ("cyclonedds.xml", "binds", "eth0") in said(document)
    check(document)


@pytest.mark.parametrize(
    ("arguments", "said"),
    [
        (["--focus", "tern-drvers.service"], "did you mean 'tern-drivers.service'?"),
        (["--layer", "cloud"], "'boot', 'environment', 'launch'"),
        (["--format", "gif"], "'dot'"),
        (["--depth", "2"], "--depth needs a --focus"),
        (["--config", "absent.toml"], "absent.toml"),
    ],
)
def test_wrong_usage_exits_2(arguments: list[str], said: str) -> None:
    run = lint("graph", "--root", ".", *arguments, cwd=ROBOTS / "good/tree")
    assert (run.code, run.stdout) == (2, "")
    assert said in run.stderr


def test_output_file(tmp_path: Path) -> None:
    tree(tmp_path, {"a.service": "[Service]\nExecStart=/bin/true\n"})
    run = lint("graph", "--output-file", "a.dot", cwd=tmp_path)
    assert run == (0, "", "")
    assert (tmp_path / "a.dot").read_text().startswith("digraph robot {")


@pytest.mark.parametrize(
    ("output", "drawing"), [("mermaid", "flowchart LR\n"), ("json", "{"), ("dot", "digraph robot {")]
)
def test_empty_tree(tmp_path: Path, output: str, drawing: str) -> None:
    run = lint("graph", "--format", output, cwd=tmp_path)
    assert (run.code, run.stderr) == (0, "")
    assert run.stdout.startswith(drawing)
    assert "class" not in run.stdout


def test_secrets_stay_masked(tmp_path: Path) -> None:
    launch = """\
<launch><arg name="x" default="a"/>
<node pkg="p" exec="e" name="n" if="$(eval 'password=\\"hunter2hunter2\\"')"/></launch>
"""
    files = {
        "a.launch.xml": launch,
        "a.service": "[Service]\nEnvironment=DB_PASSWORD=hunter2hunter2\nExecStart=/bin/x\n",
    }
    tree(tmp_path, files)
    for output in ("dot", "mermaid", "json"):
        assert "hunter2" not in lint("graph", "--format", output, cwd=tmp_path).stdout


def test_same_tree_same_picture() -> None:
    first, second = (lint("graph", "--root", ".", cwd=ROBOTS / "guide/tree").stdout for _ in range(2))
    assert first == second


@pytest.mark.corpus
def test_corpus_is_drawn(corpus: Path) -> None:
    for repository in sorted(path for path in corpus.iterdir() if path.is_dir()):
        check(drawn(repository))


def test_layer_that_fails_costs_itself_alone(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    tree(tmp_path, {"a.service": "[Service]\nUser=rover\nExecStart=/bin/true\n"})
    monkeypatch.setattr("bringup_lint.graph.edges.dds.dds_places", lambda files: 1 / 0)
    run = lint("graph", "--format", "json", cwd=tmp_path)
    assert run.code == 0
    assert run.stderr == "bringup-lint: the picture is not whole: ZeroDivisionError('division by zero')\n"
    assert ("a.service", "runs-as", "rover") in said(json.loads(run.stdout))


def test_what_the_baseline_knows_is_left_out(tmp_path: Path) -> None:
    tree(tmp_path, {"a.service": "[Service]\nExecStart=/bin/true\nRestartSec=soon\n"})
    assert lint("--write-baseline", "known.json", cwd=tmp_path).code == 0
    assert drawn(tmp_path)["findings"]
    tree(tmp_path, {"bringup-lint.toml": 'baseline = "known.json"\n'})
    assert not drawn(tmp_path)["findings"]
