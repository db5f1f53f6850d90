"""The joined graph: what the files of all layers have to do with each other."""

from __future__ import annotations

from pathlib import Path

from tests.conftest import PROJECT
from tests.drawing import ROBOTS
from tests.drawing import drawn
from tests.drawing import said
from tests.drawing import tree

PYTHON_SETUP = "from setuptools import setup\nsetup(name='p', entry_points={'console_scripts': ['e = p.e:main']})\n"
NODE = """\
import rclpy
from rclpy.node import Node


class Lift(Node):
    latched = QoSProfile(depth=1)

    def __init__(self):
        super().__init__('lift')


def main():
    rclpy.init()
    rclpy.spin(Lift())
"""
SERVICE = "[Service]\nExecStart=/bin/true\n"


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


def test_program_that_is_no_python_is_drawn_all_the_same(tmp_path: Path) -> None:
    package = "<package format='3'><name>p</name><export><build_type>ament_python</build_type></export></package>"
    files = {
        "p/package.xml": package,
        "p/setup.py": PYTHON_SETUP,
        "p/p/e.py": "def main(:\n",
        "p/launch/a.launch.xml": "<launch><node pkg='p' exec='e' name='n'/></launch>\n",
    }
    assert ("a.launch.xml", "starts", "/n") in said(drawn(tree(tmp_path, files)))


def test_units_run_scripts_of_the_tree_which_run_launch_files_and_nodes(tmp_path: Path) -> None:
    script = "#!/bin/bash\nexec ros2 launch p a.launch.xml\n"
    inner = "#!/bin/sh\n. /opt/rover/env.sh\nexec ros2 run q talker\n"
    files = {
        "opt/rover/start.sh": script,
        "opt/rover/talk.sh": inner,
        "opt/rover/env.sh": "export CYCLONEDDS_URI=file:///etc/rover/dds.xml\n",
        "opt/rover/watch.py": "print(1)\n",
        "etc/rover/dds.xml": "<CycloneDDS/>\n",
        "launch/a.launch.xml": "<launch/>\n",
        "etc/systemd/system/a.service": "[Service]\nExecStart=/opt/rover/start.sh\nExecStartPre=/opt/rover/talk.sh\n",
        "etc/systemd/system/b.service": "[Service]\nExecStart=nice -n 5 /usr/bin/python3 /opt/rover/watch.py\n",
        "etc/systemd/system/c.service": "[Service]\nExecStart=/usr/sbin/pigpiod -l\n",
    }
    assert {
        ("a.service", "runs", "start.sh"),
        ("start.sh", "runs", "a.launch.xml"),
        ("a.service", "runs", "talk.sh"),
        ("talk.sh", "runs", "env.sh"),
        ("talk.sh", "runs", "q/talker"),
        ("env.sh", "selects", "dds.xml"),
        ("b.service", "runs", "watch.py"),
        ("c.service", "runs", "/usr/sbin/pigpiod"),
    } <= said(drawn(tree(tmp_path, files)))


def test_template_stands_for_what_no_line_names(tmp_path: Path) -> None:
    files = {
        "a.service": "[Unit]\nWants=sensor@front.service\nOnFailure=alarm@%n.service\n" + SERVICE,
        "sensor@.service": "[Service]\nExecStart=/bin/sensor %i\nUser=rover\n",
        "alarm@.service": SERVICE,
        "lonely@.service": SERVICE,
    }
    document = drawn(tree(tmp_path, files))
    assert {
        ("a.service", "wants", "sensor@front.service"),
        ("sensor@front.service", "runs-as", "rover"),
        ("a.service", "on-failure", "alarm@.service"),
    } <= said(document)
    units = {node["label"]: node["path"] for node in document["nodes"] if node["kind"] == "unit"}
    assert units["sensor@front.service"] == "sensor@.service"
    assert set(units) == {"a.service", "sensor@front.service", "alarm@.service", "lonely@.service"}


def test_timers_sockets_and_mounts(tmp_path: Path) -> None:
    files = {
        "backup.timer": "[Timer]\nOnCalendar=daily\n[Install]\nWantedBy=timers.target\n",
        "backup.service": "[Unit]\nRequiresMountsFor=/data/log\n" + SERVICE,
        "data.mount": "[Mount]\nWhat=/dev/sda1\nWhere=/data\n",
        "bus.socket": "[Socket]\nListenStream=7411\n",
        "bus.service": SERVICE,
    }
    edges = said(drawn(tree(tmp_path, files)))
    assert {
        ("backup.timer", "triggers", "backup.service"),
        ("backup.timer", "orders", "timers.target"),
        ("timers.target", "wants", "backup.timer"),
        ("data.mount", "orders", "backup.service"),
        ("backup.service", "requires", "data.mount"),
        ("bus.socket", "triggers", "bus.service"),
    } <= edges


def test_variants_stay_apart(tmp_path: Path) -> None:
    files = {}
    for robot in ("one", "two"):
        files[f"{robot}/systemd/base.service"] = "[Unit]\nAfter=bus.service\n" + SERVICE
        files[f"{robot}/systemd/bus.service"] = SERVICE
        files[f"{robot}/launch/base.launch.xml"] = "<launch><node pkg='p' exec='e' name='lidar'/></launch>\n"
        files[f"{robot}/netplan/90-{robot}.yaml"] = "network:\n  ethernets:\n    eth0: {dhcp4: true}\n"
    document = drawn(tree(tmp_path, files))
    for edge in document["edges"]:
        ends = [
            {robot for robot in ("one/", "two/") if robot in edge[end] or robot[:-1] == edge[end].rpartition("@")[2]}
            for end in ("source", "target")
        ]
        assert not all(ends) or ends[0] == ends[1], edge
    assert sum(node["kind"] == "ros-node" for node in document["nodes"]) == 2
    assert sum(node["kind"] == "interface" for node in document["nodes"]) == 2


def test_user_units_are_ordered_among_themselves(tmp_path: Path) -> None:
    files = {
        "etc/systemd/user/a.service": "[Unit]\nAfter=b.service\n" + SERVICE,
        "etc/systemd/user/b.service": SERVICE,
        "etc/systemd/system/b.service": SERVICE,
    }
    document = drawn(tree(tmp_path, files))
    orders = [(edge["source"], edge["target"]) for edge in document["edges"] if edge["kind"] == "orders"]
    assert orders == [("user-unit:b.service", "user-unit:a.service")]


def test_findings_in_sources_and_dockerfiles_stand_on_what_is_made_of_them(tmp_path: Path) -> None:
    package = "<package format='3'><name>p</name><export><build_type>ament_python</build_type></export></package>"
    files = {
        "p/package.xml": package,
        "p/setup.py": PYTHON_SETUP,
        "p/p/e.py": NODE,
        "p/launch/a.launch.xml": "<launch><node pkg='p' exec='e' name='n'/></launch>\n",
        "docker/compose.yaml": "services:\n  driver:\n    build: .\n    command: ros2 run p e\n",
        "docker/Dockerfile": "FROM ros:foxy\nENV ROS_DOMAIN_ID=500\n",
    }
    document = drawn(tree(tmp_path, files))
    paths = {
        node["label"]: {document["findings"][index]["path"] for index in node["findings"]} for node in document["nodes"]
    }
    assert "p/p/e.py" in paths["/n"]
    assert "docker/Dockerfile" in paths["driver"]


def test_drop_ins_belong_to_their_unit(tmp_path: Path) -> None:
    files = {
        "etc/systemd/system/a.service": SERVICE,
        "etc/systemd/system/a.service.d/user.conf": "[Service]\nUser=rover\nRestartSec=soon\n",
    }
    document = drawn(tree(tmp_path, files))
    (edge,) = [edge for edge in document["edges"] if edge["kind"] == "runs-as"]
    assert (edge["path"], edge["line"]) == ("etc/systemd/system/a.service.d/user.conf", 2)
    (unit,) = [node for node in document["nodes"] if node["kind"] == "unit"]
    assert unit["path"] == "etc/systemd/system/a.service"
    assert "systemd/invalid-value" in [document["findings"][index]["rule"] for index in unit["findings"]]


def test_interfaces_of_dds_files_are_those_of_the_netplan_beside_them(tmp_path: Path) -> None:
    dds = (
        "<CycloneDDS><Domain><General><Interfaces><NetworkInterface name='{}'/></Interfaces></General></Domain>"
        "</CycloneDDS>\n"
    )
    netplan = """\
network:
  ethernets:
    eth0: {addresses: [10.0.0.2/24]}
  bridges:
    br0: {interfaces: [eth0]}
"""
    files = {
        "etc/netplan/10-rover.yaml": netplan,
        "etc/rover/dds.xml": dds.format("br0"),
        "other/dds.xml": dds.format("eth0"),
    }
    edges = said(drawn(tree(tmp_path, files)))
    assert {
        ("rover/dds.xml", "binds", "br0"),
        ("br0", "built-on", "eth0"),
        ("eth0", "configured-by", "10-rover.yaml"),
    } <= edges
    assert ("other/dds.xml", "binds", "eth0 (dds.xml)") in edges


def test_interfaces_of_dds_files_are_those_of_the_profiles_of_networkmanager(tmp_path: Path) -> None:
    dds = (
        "<CycloneDDS><Domain><General><Interfaces><NetworkInterface name='{}'/></Interfaces></General></Domain>"
        "</CycloneDDS>\n"
    )
    profile = "[connection]\nid={0}\nuuid={0}-0\ntype={1}\ninterface-name={0}\n{2}\n"
    folder = "etc/NetworkManager/system-connections"
    files = {
        f"{folder}/bridge.nmconnection": profile.format("br0", "bridge", "[ipv4]\nmethod=manual\naddress1=10.0.0.2/24"),
        f"{folder}/port.nmconnection": profile.format("eth0", "ethernet", "controller=br0-0\nport-type=bridge"),
        f"{folder}/cameras.nmconnection": profile.format("vlan5", "vlan", "[vlan]\nid=5\nparent=eth0"),
        f"{folder}/wifi.nmconnection": "[connection]\nid=hall\ntype=wifi\n",
        "etc/rover/dds.xml": dds.format("10.0.0.2"),
        "other/dds.xml": dds.format("eth0"),
    }
    edges = said(drawn(tree(tmp_path, files)))
    assert {
        ("rover/dds.xml", "binds", "br0"),
        ("br0", "built-on", "eth0"),
        ("vlan5", "built-on", "eth0"),
        ("br0", "configured-by", "bridge.nmconnection"),
        ("eth0", "configured-by", "port.nmconnection"),
        ("vlan5", "configured-by", "cameras.nmconnection"),
        ("other/dds.xml", "binds", "eth0 (dds.xml)"),
    } <= edges
    assert not any(target == "wifi.nmconnection" for _, _, target in edges)


def test_devices_in_parameter_files_belong_to_the_nodes_that_load_them(tmp_path: Path) -> None:
    files = {
        "p/package.xml": "<package format='3'><name>p</name></package>",
        "p/launch/a.launch.xml": (
            "<launch><node pkg='q' exec='e' name='lidar'><param from='$(dirname)/../config/a.yaml'/></node></launch>\n"
        ),
        "p/config/a.yaml": "lidar:\n  ros__parameters:\n    port: /dev/rover/lidar\n",
        "udev/70-rover.rules": 'SUBSYSTEM=="tty", ATTRS{serial}=="1", SYMLINK+="rover/lidar"\n',
    }
    assert {
        ("/lidar", "loads-params", "a.yaml"),
        ("/lidar", "opens", "/dev/rover/lidar"),
        ("a.yaml", "names", "/dev/rover/lidar"),
        ("/dev/rover/lidar", "links", "70-rover.rules:1"),
    } <= said(drawn(tree(tmp_path, files)))


def test_a_unit_that_runs_ros2_by_its_path_runs_the_launch_file_only(tmp_path: Path) -> None:
    files = {
        "launch/a.launch.xml": "<launch/>\n",
        "a.service": "[Service]\nExecStart=/opt/ros/jazzy/bin/ros2 launch p a.launch.xml\n",
    }
    runs = {edge for edge in said(drawn(tree(tmp_path, files))) if edge[1] == "runs"}
    assert runs == {("a.service", "runs", "a.launch.xml")}


def test_a_keystore_at_a_path_of_the_robot_is_that_of_the_tree(tmp_path: Path) -> None:
    permissions = (
        PROJECT / "fixtures/robots/guide/tree/etc/heron/keystore/enclaves/heron/lidar/permissions.xml"
    ).read_text()
    files = {
        "etc/rover/keystore/enclaves/heron/lidar/permissions.xml": permissions,
        "etc/rover/rover.env": "ROS_SECURITY_KEYSTORE=/etc/rover/keystore\n",
        "etc/systemd/system/a.service": "[Service]\nEnvironmentFile=/etc/rover/rover.env\nExecStart=/bin/true\n",
    }
    document = drawn(tree(tmp_path, files))
    assert [node["label"] for node in document["nodes"] if node["kind"] == "keystore"] == ["keystore"]
