"""Fixes of launch files and nodes that libcst makes: each removes its finding, makes no other, and keeps comments."""

from __future__ import annotations

from pathlib import Path

import pytest

from tests.lint import lint

LAUNCH = {
    "arg-used-before-declare": """\
LaunchDescription([
        # the driver
        Node(package='rover', executable='drive', namespace=LaunchConfiguration('robot_name')),  # drives
        # the name of the robot
        DeclareLaunchArgument('robot_name', default_value='rover'),
    ])""",
    "env-set-too-late": """\
LaunchDescription([
        Node(package='rover', executable='drive'),
        SetEnvironmentVariable('RMW_IMPLEMENTATION', 'rmw_cyclonedds_cpp'),  # the fleet's
        Node(package='rover', executable='scan'),
    ])""",
    "remap-duplicate": """\
LaunchDescription([
        Node(package='rover', executable='drive', remappings=[
            ('scan', '/front/scan'),  # the front one
            ('odom', '/odom'),
            ('scan', '/rear/scan'),
        ]),
    ])""",
    "lifecycle-order": """\
LaunchDescription([
        Node(package='nav2_lifecycle_manager', executable='lifecycle_manager', name='manager', parameters=[{
            'autostart': True,
            'node_names': ['bt_navigator', 'planner_server'],  # navigation
        }]),
    ])""",
    "use-sim-time-not-propagated": """\
LaunchDescription([
        DeclareLaunchArgument('use_sim_time', default_value='false'),
        Node(package='slam_toolbox', executable='async_slam_toolbox_node', name='slam', parameters=[
            {'use_sim_time': LaunchConfiguration('use_sim_time')},
        ]),
        Node(
            package='nav2_amcl',  # finds the robot
            executable='amcl',
            name='amcl',  # the filter
        ),
    ])""",
    "tf-not-remapped": """\
LaunchDescription([
        Node(package='nav2_amcl', executable='amcl', namespace='rover', remappings=[('/tf', 'tf')]),
        Node(package='nav2_planner', executable='planner_server', namespace='rover', remappings=[
            ('/map', 'map'),  # its own
        ]),
    ])""",
    "intra-process-unset": """\
LaunchDescription([
        ComposableNodeContainer(
            name='images', namespace='', package='rclcpp_components', executable='component_container',
            composable_node_descriptions=[
                ComposableNode(package='usb_cam', plugin='usb_cam::UsbCamNode'),  # the camera
                ComposableNode(
                    package='image_proc',
                    plugin='image_proc::RectifyNode'  # undistorts
                ),
            ],
        ),
    ])""",
    "critical-no-required": """\
LaunchDescription([
        Node(package='sllidar_ros2', executable='sllidar_node', name='laser'),  # the laser
        Node(package='nav2_amcl', executable='amcl', name='amcl'),
    ])""",
    "lc-default-shadowed": """\
LaunchDescription([
        DeclareLaunchArgument('device', default_value='/dev/laser'),
        Node(package='rover', executable='scan', namespace=LaunchConfiguration(
            'device',
            default='/dev/ttyUSB0',  # of old
        )),
    ])""",
    "respawn-unlimited": """\
LaunchDescription([
        Node(
            package='rover',
            executable='scan',
            respawn=True,
            respawn_delay=2.0,  # seconds
        ),
    ])""",
    "parameters-invalid": """\
LaunchDescription([
        Node(package='rover', executable='drive', parameters={  # of the base
            'width': 0.4,
        }),
    ])""",
    "unused-arg": """\
LaunchDescription([
        DeclareLaunchArgument('device', default_value='/dev/laser'),
        Node(package='rover', executable='scan'),  # scans
    ])""",
}
HEAD = """\
from launch import LaunchDescription
from launch.actions import DeclareLaunchArgument, IncludeLaunchDescription, SetEnvironmentVariable
from launch.launch_description_sources import PythonLaunchDescriptionSource
from launch.substitutions import LaunchConfiguration, ThisLaunchFileDir
from launch_ros.actions import ComposableNodeContainer
from launch_ros.actions import Node
from launch_ros.descriptions import ComposableNode


def generate_launch_description():
    return """


NODES = {
    "qos-missing": """\
        self.state = self.create_publisher(String, 'state', queue_size=1)  # for the screen
        self.sound = self.create_publisher(
            String,
            'sound',  # what it says
        )
""",
    "service-wait-no-timeout": """\
        self.homing = self.create_client(Trigger, 'home')
        # the arm has to be there
        self.homing.wait_for_service()  # forever
        self.get_logger().info('ready')
""",
}
NODE = """\
import rclpy
from rclpy.node import Node
from std_msgs.msg import String
from std_srvs.srv import Trigger


class Rover(Node):
    def __init__(self):
        super().__init__('rover')
"""
CASES = {
    **{f"launch/{rule}": ("robot.launch.py", HEAD + text + "\n") for rule, text in LAUNCH.items()},
    **{f"node/{rule}": ("rover.py", NODE + text) for rule, text in NODES.items()},
}
SCAN = """\
LaunchDescription([
        DeclareLaunchArgument('params', default_value='/etc/robot/scan.yaml'),
        Node(package='rover', executable='scan', parameters=[LaunchConfiguration('params')]),
    ])"""
INCLUDE = """\
LaunchDescription([
        IncludeLaunchDescription(PythonLaunchDescriptionSource([ThisLaunchFileDir(), '/scan.launch.py'])),
        IncludeLaunchDescription(PythonLaunchDescriptionSource([ThisLaunchFileDir(), '/gps.launch.py'])),  # last
    ])"""
CASES["launch/arg-leak"] = ("robot.launch.py", HEAD + INCLUDE + "\n")
BESIDE = {
    "launch/respawn-unlimited": {"bringup-lint.toml": 'target-ros = "jazzy"\n'},
    "launch/arg-leak": {
        "scan.launch.py": HEAD + SCAN + "\n",
        "gps.launch.py": HEAD + SCAN.replace("scan", "gps") + "\n",
    },
}


@pytest.mark.parametrize("line_end", ["\n", "\r\n"], ids=["lf", "crlf"])
@pytest.mark.parametrize("rule", CASES)
def test_fix_removes_the_finding_and_makes_no_other(rule: str, line_end: str, tmp_path: Path) -> None:
    name, text = CASES[rule]
    path = tmp_path / name
    for other, content in BESIDE.get(rule, {}).items():
        (tmp_path / other).write_text(content)
    path.write_bytes(text.replace("\n", line_end).encode())
    options = ("--output-format", "concise", "--min-severity", "info", ".")
    before = lint(*options, cwd=tmp_path).stdout.splitlines()
    assert any(f"[{rule}]" in line for line in before)
    lint("--fix", "--unsafe-fixes", "--select", rule, *options, cwd=tmp_path)
    fixed = path.read_bytes().decode()
    compile(fixed, name, "exec")
    after = lint(*options, cwd=tmp_path).stdout.splitlines()
    assert sorted(map(rules_of, after)) == sorted(rules_of(line) for line in before if f"[{rule}]" not in line)
    assert [line for line in comments(text) if line not in comments(fixed)] == []
    assert fixed.count("\r") == (fixed.count("\n") if line_end == "\r\n" else 0)
    lint("--fix", "--unsafe-fixes", "--select", rule, *options, cwd=tmp_path)
    assert path.read_bytes().decode() == fixed


def rules_of(line: str) -> str:
    return line.partition("[")[2].partition("]")[0]


def comments(text: str) -> list[str]:
    return [line.partition("# ")[2].strip() for line in text.splitlines() if "# " in line]
