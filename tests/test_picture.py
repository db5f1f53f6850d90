"""``bringup-lint graph``: one graph of all layers, and its picture in every format."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

import pytest

from bringup_lint.graph import layers
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
        ("ros.env", "selects", "cyclonedds.xml"),
        ("cyclonedds.xml", "binds", "eth0"),
        ("eth0", "configured-by", "60-heron.yaml"),
        ("/lidar", "opens", "/dev/heron/lidar"),
        ("/dev/heron/lidar", "links", "99-heron.rules:6"),
        ("/heron/lidar", "grants", "permissions.xml"),
        ("/lidar", "publishes", "/scan"),
        ("/slam", "subscribes", "/scan"),
    } <= edges


def test_device_units_lead_to_the_device_and_its_rule() -> None:
    edges = said(drawn(ROBOTS / "good/tree", "--root", "."))
    assert {
        ("tern-drivers.service", "binds-to", "dev-tern-lidar.device"),
        ("dev-tern-lidar.device", "stands-for", "/dev/tern/lidar"),
        ("/lidar", "opens", "/dev/tern/lidar"),
        ("/dev/tern/lidar", "links", "70-tern.rules:2"),
        ("tern-drivers.service", "on-failure", "tern-alarm@.service"),
        ("tern-alarm@.service", "runs", "tern-alarm"),
    } <= edges


def test_compose_services_are_joined_to_what_they_run_and_to_the_unit_that_starts_them(tmp_path: Path) -> None:
    compose = """\
services:
  driver:
    image: ros:jazzy
    command: ros2 launch rover_bringup drivers.launch.py
    env_file: rover.env
    devices: ["/dev/rover/lidar:/dev/rover/lidar"]
    depends_on: [bus]
  bus:
    image: busybox
"""
    package = "<package format='3'><name>rover_bringup</name></package>"
    files = {
        "opt/rover/compose.yaml": compose,
        "opt/rover/rover.env": "ROS_DOMAIN_ID=3\n",
        "src/rover_bringup/package.xml": package,
        "src/rover_bringup/launch/drivers.launch.py": "def generate_launch_description(): return None\n",
        "etc/systemd/system/rover.service": "[Service]\nExecStart=docker compose -f /opt/rover/compose.yaml up\n",
    }
    assert {
        ("rover.service", "runs", "driver"),
        ("driver", "runs", "drivers.launch.py"),
        ("driver", "loads-env", "rover.env"),
        ("driver", "opens", "/dev/rover/lidar"),
        ("driver", "requires", "bus"),
        ("bus", "orders", "driver"),
    } <= said(drawn(tree(tmp_path, files)))


def test_enclaves_lead_from_launch_files_to_permissions(tmp_path: Path) -> None:
    permissions = (
        PROJECT / "fixtures/robots/guide/tree/etc/heron/keystore/enclaves/heron/lidar/permissions.xml"
    ).read_text()
    launch = """\
<launch><node pkg="p" exec="e" name="lidar" ros_args="--enclave /heron/lidar"/></launch>
"""
    python = """\
from launch import LaunchDescription
from launch_ros.actions import Node

def generate_launch_description():
    return LaunchDescription([
        Node(package='p', executable='e', name='lidar', arguments=['--ros-args', '--enclave', '/heron/lidar']),
    ])
"""
    files = {
        "keystore/enclaves/heron/lidar/permissions.xml": permissions,
        "keystore/enclaves/heron/lidar/cert.pem": "",
        "rover.env": "ROS_SECURITY_KEYSTORE=/etc/rover/keystore\n",
        "launch/a.launch.xml": launch,
        "launch/b.launch.py": python,
    }
    edges = said(drawn(tree(tmp_path, files)))
    assert {
        ("/lidar (b.launch.py)", "secures", "/heron/lidar"),
        ("keystore", "holds", "/heron/lidar"),
        ("/heron/lidar", "grants", "permissions.xml"),
        ("rover.env", "selects", "/etc/rover/keystore"),
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


@pytest.mark.parametrize("robot", ["good", "guide"])
def test_published_schema_describes_the_picture(robot: str) -> None:
    check(drawn(ROBOTS / robot / "tree", "--root", "."))


def check(document: dict[str, Any]) -> None:
    """The schema, and what it cannot say: every reference leads somewhere."""
    jsonschema = pytest.importorskip("jsonschema")
    schema = json.loads((PROJECT / "docs/graph.schema.json").read_text("utf-8"))
    jsonschema.Draft202012Validator.check_schema(schema)
    jsonschema.Draft202012Validator(schema).validate(document)
    ids = [node["id"] for node in document["nodes"]]
    assert len(ids) == len(set(ids))
    assert {end for edge in document["edges"] for end in (edge["source"], edge["target"])} <= set(ids)
    numbers = {index for each in (*document["nodes"], *document["edges"]) for index in each["findings"]}
    assert numbers <= set(range(len(document["findings"])))
    ranks = {node["id"]: node["rank"] for node in document["nodes"]}
    for edge in document["edges"]:
        if edge["kind"] == "orders" and ranks[edge["source"]] is not None:
            assert ranks[edge["source"]] <= ranks[edge["target"]]


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
    monkeypatch.setattr("bringup_lint.graph.dds.edges.dds_places", lambda robot: 1 / 0)
    run = lint("graph", "--format", "json", cwd=tmp_path)
    assert run.code == 0
    assert run.stderr == "bringup-lint: the picture is not whole: ZeroDivisionError('division by zero')\n"
    assert ("a.service", "runs-as", "rover") in said(json.loads(run.stdout))
