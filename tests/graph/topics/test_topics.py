"""The topic layer: names, remappings, parameters, C++ sources, and what runs together."""

from __future__ import annotations

import shutil
from pathlib import Path

import pytest
from hypothesis import given
from hypothesis import strategies as st

from bringup_lint.discover.walk import discover
from bringup_lint.facts import table
from bringup_lint.graph.edges.topics import topic_edges
from bringup_lint.graph.topics.questions.coexistence import coexist as meets
from bringup_lint.graph.topics.questions.command_sources import is_stop
from bringup_lint.graph.topics.questions.command_sources import is_velocity
from bringup_lint.graph.topics.resolved.names import complaint
from bringup_lint.graph.topics.resolved.names import expand
from bringup_lint.graph.topics.resolved.names import full_complaint
from bringup_lint.graph.topics.resolved.remapping import remap
from bringup_lint.graph.topics.resolved.remapping import remapping
from bringup_lint.graph.topics.sources.known import known_node
from bringup_lint.parsers import cpp_node
from bringup_lint.parsers import rviz
from bringup_lint.robot import Robot
from bringup_lint.source import Source
from tests.conftest import PROJECT

FIXTURES = PROJECT / "fixtures"


@pytest.mark.parametrize(
    ("name", "full"),
    [
        ("scan", "/r1/scan"),
        ("~/scan", "/r1/n/scan"),
        ("/scan", "/scan"),
        ("{node}/scan", "/r1/n/scan"),
        ("{ns}/scan", "/r1/scan"),
        ("a-b", None),
        ("{other}/scan", None),
    ],
)
def test_expansion(name: str, full: str | None) -> None:
    assert expand(name, "n", "/r1") == full


@pytest.mark.parametrize("name", ["", "a-b", "a.b", "a b", "é", "1a", "a/1b", "a/", "~xy", "a~b", "{a", "a}"])
def test_refused_names(name: str) -> None:
    assert complaint(name)


@pytest.mark.parametrize("name", ["__x", "a__b", "rt/scan", "_x", "Scan", "a//b", "{node}"])
def test_odd_names_that_are_taken(name: str) -> None:
    assert complaint(name) is None


def test_repeated_slashes_fail_only_when_expanded() -> None:
    assert full_complaint("/a//b") == "it contains '//'"


def test_a_rule_for_another_node_does_not_count() -> None:
    rules = [remapping("other:scan:=far"), remapping("scan:=near"), remapping("scan:=later")]
    assert remap(rules, "/scan", "lidar", "/").name == "/near"
    assert remap(rules, "/scan", "other", "/").name == "/far"


def test_an_unknown_target_makes_the_name_unknown() -> None:
    rule = remapping("scan:=somewhere")._replace(replacement=None)
    assert remap([rule], "/scan", "lidar", "/").name is None
    assert remap([rule], "/odom", "lidar", "/").name == "/odom"


def test_each_known_node_is_whole() -> None:
    for row in table("ros/node_topics"):
        assert row["role"] in ("pub", "sub", "more", "none", "node")
        assert row["role"] not in ("pub", "sub") or row["name"] or row["parameter"]
        assert len(row["qos"].split()) in (0, 2, 3)
        if row["name"] and row["role"] in ("pub", "sub"):
            assert complaint(row["name"]) is None
        assert known_node(row["package"], row["executable"]) is not None


@pytest.mark.parametrize(
    ("name", "velocity", "stop"),
    [
        ("cmd_vel", True, False),
        ("/r1/cmd_vel_raw", True, False),
        ("base_cmd_vel", True, False),
        ("odom", False, False),
        ("e_stop", False, True),
        ("/r1/emergency_stop/state", False, True),
        ("stopwatch", False, False),
        ("estops_seen", False, False),
    ],
)
def test_commands(name: str, velocity: bool, stop: bool) -> None:
    assert (is_velocity(name), is_stop(name)) == (velocity, stop)


CPP = """
// create_publisher<a::msg::B>("comment", 10);
/* create_publisher<a::msg::B>("block", 10); */
using sensor_msgs::msg::LaserScan;
using Pose = geometry_msgs::msg::PoseStamped;
class Lidar : public rclcpp::Node
{
public:
  explicit Lidar(const rclcpp::NodeOptions & options) : Node("lidar", options)
  {
    log("create_publisher<a::msg::B>(\\"text\\", 10)");
    auto quality = rclcpp::QoS(rclcpp::KeepLast(3)).best_effort();
    scans_ = create_publisher<LaserScan>("scan", quality);
    poses_ = this->create_publisher<Pose>("~/pose", rclcpp::QoS(1).transient_local().reliable());
    raw_ = create_publisher<sensor_msgs::msg::Image>("raw", rclcpp::SensorDataQoS());
    other_ = create_publisher<sensor_msgs::msg::Image>(name_ + "/raw", 5);
    subscription_ = this->create_subscription<std_msgs::msg::Bool>(
      "stop", 7, [this](const std_msgs::msg::Bool & message) {stop(message, "now");});
    late_ = create_publisher<sensor_msgs::msg::Image>("late", make_quality());
  }
};
RCLCPP_COMPONENTS_REGISTER_NODE(field::Lidar)
"""


def test_cpp_sources() -> None:
    node = cpp_node.parse(Source("lidar.cpp", CPP))
    found = [
        (each.role, each.name, each.type, each.qos and (each.qos.reliability, each.qos.durability, each.qos.depth))
        for each in node.endpoints
    ]
    assert found == [
        ("publisher", "scan", "sensor_msgs/msg/LaserScan", ("BEST_EFFORT", "VOLATILE", 3)),
        ("publisher", "~/pose", "geometry_msgs/msg/PoseStamped", ("RELIABLE", "TRANSIENT_LOCAL", 1)),
        ("publisher", "raw", "sensor_msgs/msg/Image", ("BEST_EFFORT", "VOLATILE", 5)),
        ("publisher", None, "sensor_msgs/msg/Image", ("RELIABLE", "VOLATILE", 5)),
        ("subscription", "stop", "std_msgs/msg/Bool", ("RELIABLE", "VOLATILE", 7)),
        ("publisher", "late", "sensor_msgs/msg/Image", None),
    ]
    assert node.names == ["lidar"]
    assert node.classes == ["Lidar"]
    assert node.components == ["field::Lidar"]
    assert [each.name.span.text for each in node.endpoints if each.name] == ["scan", "~/pose", "raw", "stop", "late"]


PARAMETERS = """
// declare_parameter("scan_topic", "comment");
declare_parameter("scan_topic", "front/scan");
get_parameter("scan_topic", scan_topic_);
create_subscription<sensor_msgs::msg::LaserScan>(scan_topic_, 10, callback);
const auto odometry = node->declare_parameter<std::string>("odometry", std::string("odom"));
node->create_subscription<nav_msgs::msg::Odometry>(odometry, 10, callback);
map_topic_ = get_parameter("map").as_string();
map_topic_ = "/" + map_topic_;
create_publisher<nav_msgs::msg::OccupancyGrid>(map_topic_, 1);
late = this->get_parameter("late").as_string();
create_publisher<std_msgs::msg::Bool>(late, 1);
"""


def test_names_that_parameters_give() -> None:
    found = cpp_node.parse(Source("a.cpp", PARAMETERS)).endpoints
    assert [(each.parameter, each.name) for each in found] == [
        ("scan_topic", "front/scan"),
        ("odometry", "odom"),
        (None, None),
        ("late", None),
    ]
    assert found[1].name.span.text == "odom"


def test_a_profile_that_changes_later_is_not_known() -> None:
    text = 'rclcpp::QoS qos(5);\nqos.best_effort();\nnode->create_publisher<std_msgs::msg::Bool>("a", qos);'
    assert cpp_node.parse(Source("a.cpp", text)).endpoints[0].qos is None


PIECES = st.sampled_from(
    [
        "create_publisher<",
        "std_msgs::msg::Bool",
        ">",
        "(",
        ")",
        '"',
        "a",
        ",",
        "//",
        "/*",
        "*/",
        "\n",
        "'",
        'R"(',
        ')"',
        "{",
    ]
)


@given(st.lists(PIECES, max_size=40).map("".join))
def test_any_text_is_read(text: str) -> None:
    source = Source("a.cpp", text)
    for endpoint in cpp_node.parse(source).endpoints:
        assert 0 <= endpoint.span.start <= endpoint.span.end <= len(text)


def robot_of(*files: tuple[Path, str]) -> Robot:
    for path, text in files:
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(text)
    return Robot(discover([str(files[0][0].parents[0])]))


LAUNCH = """
<launch>
  <arg name="side" default="left"/>
  <group>
    <push-ros-namespace namespace="mower"/>
    <set_remap from="joy" to="pad"/>
    <node pkg="joy" exec="joy_node" name="pad_driver"/>
    <node pkg="teleop_twist_joy" exec="teleop_node">
      <remap from="cmd_vel" to="/$(var side)/cmd_vel"/>
    </node>
  </group>
  <node pkg="nav2_amcl" exec="amcl">
    <param name="scan_topic" value="front/scan"/>
  </node>
  <node pkg="slam_toolbox" exec="async_slam_toolbox_node">
    <param from="$(dirname)/slam.yaml"/>
  </node>
  <node pkg="nav2_map_server" exec="map_server" ros_args="-r map:=lawn"/>
  <node pkg="unknown_driver" exec="driver"/>
</launch>
"""
SLAM = """
/**:
  ros__parameters:
    scan_topic: rear/scan
"""


def test_full_names(tmp_path: Path) -> None:
    robot = robot_of((tmp_path / "robot.launch.xml", LAUNCH), (tmp_path / "slam.yaml", SLAM))
    (running,) = robot.topics.entries
    found = {(node.label(), use.role[:3], use.topic) for node in running.nodes for use in node.uses}
    assert {
        ("/mower/pad_driver", "pub", "/mower/pad"),
        ("/mower/pad_driver", "sub", "/mower/joy/set_feedback"),
        ("/mower/teleop_twist_joy_node", "sub", "/mower/pad"),
        ("/mower/teleop_twist_joy_node", "pub", "/left/cmd_vel"),
        ("/amcl", "sub", "/front/scan"),
        ("/slam_toolbox", "sub", "/rear/scan"),
        ("/slam_toolbox", "pub", "/map"),
    } <= found
    assert not running.complete
    assert {edge.kind for edge in topic_edges(robot.topics)} == {"publishes", "subscribes"}


def test_files_in_folders_that_tell_nothing_are_for_one_robot(tmp_path: Path) -> None:
    robot = robot_of((tmp_path / "robot.launch.xml", LAUNCH))
    one, other = (Source(str(tmp_path / name)) for name in ("tools/start.sh", "docker/run/enter.sh"))
    assert robot.same_robot(one, other)


RVIZ = """
Visualization Manager:
  Displays:
    - Class: rviz_common/Group
      Enabled: true
      Displays:
        - Class: rviz_default_plugins/LaserScan
          Enabled: true
          Topic: {Depth: 5, Durability Policy: Volatile, Reliability Policy: Reliable, Value: /scan}
        - Class: rviz_default_plugins/Map
          Enabled: false
          Topic: {Durability Policy: Transient Local, Reliability Policy: Reliable, Value: /map}
    - Class: rviz_common/Group
      Enabled: false
      Displays:
        - Class: rviz_default_plugins/Path
          Enabled: true
          Topic: {Reliability Policy: Best Effort, Value: /plan}
    - Class: rviz_default_plugins/RobotModel
      Enabled: true
      Description Topic: {Depth: 1, Durability Policy: Transient Local, Reliability Policy: Best Effort, Value: /model}
"""


def test_displays_of_rviz() -> None:
    found = [
        (str(each.topic), each.type, each.reliability, each.durability) for each in rviz.parse(Source("a.rviz", RVIZ))
    ]
    assert found == [
        ("/scan", "sensor_msgs/msg/LaserScan", "RELIABLE", "VOLATILE"),
        ("/model", "std_msgs/msg/String", "BEST_EFFORT", "TRANSIENT_LOCAL"),
    ]


@given(st.text(max_size=60))
def test_any_rviz_text_is_read(text: str) -> None:
    assert isinstance(rviz.parse(Source("a.rviz", text)), list)


def test_what_runs_together() -> None:
    robot = Robot(discover([str(FIXTURES / "node/cmd_vel_multiple_publishers/bad_units")]))
    labels = [(running.label.rpartition("/")[2], len(running.nodes)) for running in robot.topics.runs]
    assert labels == [("the units", 3), ("dock.launch.py", 1), ("wire.launch.py", 2)]


COMPOSE = """
services:
  wire:
    image: ros:jazzy
    command: ros2 launch mower wire.launch.py
  dock:
    image: ros:jazzy
    command: ros2 launch mower dock.launch.py
"""


@pytest.mark.parametrize(
    ("more", "nodes"),
    [
        ("", 3),
        ("    environment:\n      ROS_DOMAIN_ID: '0'\n", 3),
        ("    profiles: [manual]\n", 2),
    ],
)
def test_services_of_one_compose_file_run_together(tmp_path: Path, more: str, nodes: int) -> None:
    mower = FIXTURES / "node/cmd_vel_multiple_publishers/bad_units/mower"
    shutil.copytree(mower, tmp_path / "mower")
    robot = robot_of((tmp_path / "compose.yaml", COMPOSE + more))
    assert len(robot.topics.runs[0].nodes) == nodes
    assert (len({use.node.name for use in robot.topics.runs[0].by_topic()["/cmd_vel"]}) == 3) == (nodes == 3)


def test_services_of_different_domains_do_not_meet(tmp_path: Path) -> None:
    mower = FIXTURES / "node/cmd_vel_multiple_publishers/bad_units/mower"
    shutil.copytree(mower, tmp_path / "mower")
    text = COMPOSE.replace("wire.launch.py\n", "wire.launch.py\n    environment: {ROS_DOMAIN_ID: '1'}\n")
    robot = robot_of((tmp_path / "compose.yaml", f"{text}    environment: {{ROS_DOMAIN_ID: '2'}}\n"))
    assert [len(running.nodes) for running in robot.topics.runs] == [1, 2]


MEETING = """
from launch import LaunchDescription
from launch.actions import RegisterEventHandler
from launch.event_handlers import OnProcessExit
from launch_ros.actions import Node


def generate_launch_description():
    first = Node(package="joy", executable="joy_node", name="first")
    then = Node(package="joy", executable="joy_node", name="then")
    far = Node(package="joy", executable="joy_node", name="far", additional_env={"ROS_DOMAIN_ID": "5"})
    late = RegisterEventHandler(OnProcessExit(target_action=first, on_exit=[then]))
    return LaunchDescription([first, Node(package="joy", executable="joy_node", name="beside"), late, far])
"""


def test_who_meets(tmp_path: Path) -> None:
    robot = robot_of((tmp_path / "joy.launch.py", MEETING))
    nodes = {node.name: node for node in robot.topics.entries[0].nodes}
    assert meets(nodes["first"], nodes["beside"])
    assert meets(nodes["then"], nodes["beside"])
    assert not meets(nodes["first"], nodes["then"])
    assert not meets(nodes["first"], nodes["far"])
