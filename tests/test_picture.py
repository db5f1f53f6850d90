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
        ("ros.env", "selects", "cyclonedds.xml"),
        ("cyclonedds.xml", "binds", "eth0"),
        ("eth0", "configured-by", "60-heron.yaml"),
        ("/lidar", "opens", "/dev/heron/lidar"),
        ("/dev/heron/lidar", "links", "99-heron.rules:6"),
        ("/heron/lidar", "grants", "permissions.xml"),
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
        ("/lidar", "secures", "/heron/lidar"),
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
