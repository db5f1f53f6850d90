"""Safe fixes leave alone what they would break or change."""

from __future__ import annotations

import json
from pathlib import Path

import pytest

from tests.lint import lint

LAUNCH = """from launch import LaunchDescription
from launch.actions import DeclareLaunchArgument
from launch.conditions import IfCondition
from launch.substitutions import LaunchConfiguration
from launch_ros.actions import Node
COMMON = [('scan', 'scan_raw')]
def generate_launch_description():
    return LaunchDescription([
        DeclareLaunchArgument('rviz', default_value='yes', choices=['yes', 'no']),
        Node(package='a', executable='b', name='c', remappings=[('scan', 'scan_front')] + COMMON),
        Node(package='a', executable='b', name='d', remappings=COMMON,
             condition=IfCondition(LaunchConfiguration('rviz'))),
    ])
"""
NETPLAN = "network:\n  version: 2\n  ethernets:\n    eth0:\n      addresses: [10.0.0.2/24]\n"
NODE = """import rclpy
from geometry_msgs.msg import Twist
from rclpy.node import Node


class Driver(Node):
    def __init__(self):
        super().__init__('driver')
        self.publisher = self.create_publisher(Twist, 'cmd_vel')
        twist = Twist()
        twist.linear.x = 1
        self.publisher.publish(twist)


rclpy.init()
rclpy.spin(Driver())
"""
LEFT = {
    "cyclonedds/abbreviated-name": (
        "cyclonedds.xml",
        '<CycloneDDS><Domain id="any"><Discovery><Peers><Peer addr="10.0.0.1" Address="10.0.0.2"/></Peers></Discovery>'
        "</Domain></CycloneDDS>\n",
    ),
    "cyclonedds/peer-missing-address": (
        "cyclonedds.xml",
        '<CycloneDDS><Domain id="any"><Discovery><Peers><Peer PruneDelay="3s">10.0.0.4<!-- the base --></Peer></Peers>'
        "</Discovery></Domain></CycloneDDS>\n",
    ),
    "env/ros-static-peers-separator": (
        "start.sh",
        "#!/bin/bash\nROS_STATIC_PEERS=10.0.0.1,10.0.0.2 ros2 launch a b.py\n",
    ),
    "launch/condition-literal": ("a.launch.py", LAUNCH),
    "launch/remap-duplicate": ("a.launch.py", LAUNCH),
    "launch/ros1-construct": (
        "a.launch.xml",
        '<launch>\n  <node pkg="p" type="n" exec="n" name="q"/>\n</launch>\n',
    ),
    "netplan/gateway-deprecated": (
        "etc/netplan/01.yaml",
        NETPLAN + "      gateway4: &gw 10.0.0.1\n    eth1: {addresses: [10.0.1.2/24], gateway4: *gw}\n",
    ),
    "netplan/renderer-unknown": (
        "etc/netplan/01.yaml",
        NETPLAN.replace("  ethernets", "  renderer: network\n  ethernets"),
    ),
    "netplan/route-to-default-old": (
        "etc/netplan/01.yaml",
        NETPLAN + "      routes:\n        - to: ::/0\n          scope: link\n",
    ),
    "node/message-field": ("driver.py", NODE),
    "node/qos-missing": ("driver.py", NODE),
    "params/empty-node-or-block": ("config/a.yaml", "a: &a\nb:\n  ros__parameters:\n    rate: 1\n"),
    "params/missing-ros-parameters": (
        "config/a.yaml",
        "a:\n  ros_parameters:\n    rate: 1\n  ros__parameters:\n    rate: 2\n",
    ),
    "systemd/legacy-key": (
        "robot.service",
        "[Service]\nExecStart=/bin/x\nStartLimitInterval=0\nMemoryMax=1G\nMemoryLimit=2G\n[Unit]\nStartLimitIntervalSec=9\n",
    ),
}


RENAMED = {
    "compose/unknown-key": (
        "compose.yaml",
        "services:\n  driver:\n    image: robot/driver:1.2\n    priviledged: true\n    privileged: false\n",
    ),
    "cyclonedds/deprecated-element": (
        "cyclonedds.xml",
        '<CycloneDDS><Domain id="any"><Internal><Watermarks><WhcAdaptative>true</WhcAdaptative>'
        "<WhcAdaptive>true</WhcAdaptive></Watermarks></Internal></Domain></CycloneDDS>\n",
    ),
    "cyclonedds/unknown-attribute": (
        "cyclonedds.xml",
        '<CycloneDDS><Domain id="any"><General><Interfaces><NetworkInterface nme="eth0" name="eth1"/></Interfaces>'
        "</General></Domain></CycloneDDS>\n",
    ),
    "cyclonedds/unknown-element": (
        "cyclonedds.xml",
        '<CycloneDDS><Domain id="any"><General><AllowMulticst>false</AllowMulticst>'
        "<allowmulticast>true</allowmulticast></General></Domain></CycloneDDS>\n",
    ),
    "fastdds/unknown-element": (
        "fastdds.xml",
        '<dds xmlns="http://www.eprosima.com"><profiles><participant profile_name="a"><rtps>'
        "<useBuiltinTransport>true</useBuiltinTransport><useBuiltinTransprts>true</useBuiltinTransprts>"
        "</rtps></participant></profiles></dds>\n",
    ),
    "launch/unknown-attribute": (
        "a.launch.xml",
        '<launch>\n  <node pkg="p" exec="e"\n    outpt="log" output="screen"/>\n</launch>\n',
    ),
    "launch/ros1-construct": (
        "b.launch.xml",
        '<launch>\n  <node pkg="p" type="n"\nexec="n" name="q"/>\n</launch>\n',
    ),
    "netplan/bad-top-level": ("etc/netplan/01.yaml", NETPLAN + "netwrok:\n  version: 2\n"),
    "netplan/unknown-key": (
        "etc/netplan/01.yaml",
        NETPLAN + "      adresses: [10.0.0.3/24]\n    eth1:\n      dhpc4: true\n      dchp4: false\n",
    ),
}
"""Names that would be there twice if they had the right one."""


@pytest.mark.parametrize("rule", LEFT)
def test_a_safe_fix_leaves_it_alone(rule: str, tmp_path: Path) -> None:
    name, text = LEFT[rule]
    path = tmp_path / name
    path.parent.mkdir(parents=True, exist_ok=True)
    path.write_text(text)
    options = ("--select", rule, "--output-format", "concise", "--min-severity", "info", ".")
    assert f"[{rule}]" in lint(*options, cwd=tmp_path).stdout
    lint("--fix", *options, cwd=tmp_path)
    assert path.read_text() == text


@pytest.mark.parametrize("rule", RENAMED)
def test_nothing_gets_a_name_that_is_there_already(rule: str, tmp_path: Path) -> None:
    name, text = RENAMED[rule]
    path = tmp_path / name
    path.parent.mkdir(parents=True, exist_ok=True)
    path.write_text(text)
    options = ("--select", rule, "--output-format", "json", "--min-severity", "info", ".")
    found = json.loads(lint(*options, cwd=tmp_path).stdout)["findings"]
    assert {each["rule"] for each in found} == {rule}
    assert [each["fix"] for each in found] == [None] * len(found)
