"""Safe fixes leave alone what they would break or change."""

from __future__ import annotations

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
