"""A generated robot: units with drop-ins, udev rules, networks, DDS profiles, launch and parameter files, node sources.

Everything grows by one number, and each copy has names of its own, so that the files refer to each other as those of
one bigger robot do.
"""

from __future__ import annotations

from pathlib import Path

UNIT = """\
[Unit]
Description=Driver {n} of the robot
Wants=network-online.target
After=network-online.target driver-{previous}.service
Requires=driver-{previous}.service

[Service]
User=robot
EnvironmentFile=/etc/robot/driver-{n}.env
ExecStart=/bin/bash -c 'source /opt/ros/jazzy/setup.bash && exec ros2 launch robot_bringup driver_{n}.launch.py'
Restart=always
RestartSec=1
KillSignal=SIGINT
TimeoutStopSec=20

[Install]
WantedBy=multi-user.target
"""
DROPIN = "[Service]\nEnvironment=ROS_DOMAIN_ID={domain}\nDeviceAllow=/dev/driver{n} rw\n"
ENVIRONMENT = (
    "RMW_IMPLEMENTATION=rmw_cyclonedds_cpp\nCYCLONEDDS_URI=file:///etc/robot/driver-{n}.xml\nPORT=/dev/driver{n}\n"
)
UDEV = """\
# Driver {n}
SUBSYSTEM=="tty", ATTRS{{idVendor}}=="0403", ATTRS{{serial}}=="A{n:06}", SYMLINK+="driver{n}", MODE="0660"
"""
PROFILE = """\
<?xml version="1.0" encoding="UTF-8"?>
<CycloneDDS xmlns="https://cdds.io/config">
  <Domain Id="any">
    <General>
      <Interfaces><NetworkInterface name="robot{n}" priority="default" multicast="default"/></Interfaces>
      <MaxMessageSize>65500B</MaxMessageSize>
    </General>
    <Internal><SocketReceiveBufferSize min="1MB"/></Internal>
  </Domain>
</CycloneDDS>
"""
NETWORK = "network:\n  version: 2\n  ethernets:\n    robot{n}:\n      addresses: [10.{high}.{low}.1/24]\n"
LAUNCH = """\
from launch import LaunchDescription
from launch.actions import DeclareLaunchArgument
from launch.substitutions import LaunchConfiguration
from launch_ros.actions import Node
from launch_ros.substitutions import FindPackageShare


def generate_launch_description():
    port = DeclareLaunchArgument("port", default_value="/dev/driver{n}", description="Serial port")
    driver = Node(
        package="robot_bringup",
        executable="driver",
        name="driver_{n}",
        namespace="robot",
        parameters=[
            [FindPackageShare("robot_bringup"), "/config/driver_{n}.yaml"],
            {{"port": LaunchConfiguration("port")}},
        ],
        remappings=[("odom", "odom_{n}")],
        output="screen",
    )
    return LaunchDescription([port, driver])
"""
XML_LAUNCH = """\
<launch>
  <arg name="rate_{n}" default="10"/>
  <include file="$(find-pkg-share robot_bringup)/launch/driver_{n}.launch.py"/>
  <node pkg="robot_bringup" exec="monitor" name="monitor_{n}">
    <param name="rate" value="$(var rate_{n})"/>
    <remap from="status" to="/robot/status_{n}"/>
  </node>
</launch>
"""
PARAMETERS = """\
/robot/driver_{n}:
  ros__parameters:
    port: /dev/driver{n}
    baud_rate: 115200
    frame_id: base_{n}
    limits: {{velocity: 1.5, acceleration: [0.5, 0.5, 1.0]}}
    gains:
      p: 1.0
      i: 0.1
      d: 0.01
"""
NODE = """\
import rclpy
from rclpy.node import Node
from std_msgs.msg import String


class Driver{n}(Node):
    def __init__(self):
        super().__init__("driver_{n}")
        self.declare_parameter("port", "/dev/driver{n}")
        self.publisher = self.create_publisher(String, "status_{n}", 10)
        self.create_subscription(String, "command_{n}", self.on_command, 10)
        self.create_timer(0.1, self.tick)

    def on_command(self, message):
        self.get_logger().info(message.data)

    def tick(self):
        self.publisher.publish(String())


def main():
    rclpy.init()
    rclpy.spin(Driver{n}())
"""
PACKAGE = """\
<?xml version="1.0"?>
<package format="3">
  <name>robot_bringup</name>
  <version>1.0.0</version>
  <description>Starts the robot</description>
  <maintainer email="robot@example.com">Robot</maintainer>
  <license>Apache-2.0</license>
  <exec_depend>launch_ros</exec_depend>
  <exec_depend>rclpy</exec_depend>
  <exec_depend>std_msgs</exec_depend>
</package>
"""
FILES = {
    "etc/systemd/system/driver-{n}.service": UNIT,
    "etc/systemd/system/driver-{n}.service.d/domain.conf": DROPIN,
    "etc/robot/driver-{n}.env": ENVIRONMENT,
    "etc/robot/driver-{n}.xml": PROFILE,
    "etc/udev/rules.d/70-driver-{n}.rules": UDEV,
    "etc/netplan/70-driver-{n}.yaml": NETWORK,
    "src/robot_bringup/launch/driver_{n}.launch.py": LAUNCH,
    "src/robot_bringup/launch/monitor_{n}.launch.xml": XML_LAUNCH,
    "src/robot_bringup/config/driver_{n}.yaml": PARAMETERS,
    "src/robot_bringup/robot_bringup/driver_{n}.py": NODE,
}
"""Path below the folder of the robot -> text."""


def generate(folder: Path, drivers: int) -> Path:
    """Write a robot with so many drivers, ten files each."""
    for number in range(drivers):
        values = {
            "n": number,
            "previous": max(number - 1, 0),
            "domain": number % 100,
            "high": number // 250,
            "low": number % 250,
        }
        for path, text in FILES.items():
            _write(folder / path.format(**values), text.format(**values))
    _write(folder / "src/robot_bringup/package.xml", PACKAGE)
    return folder


def _write(path: Path, text: str) -> None:
    path.parent.mkdir(parents=True, exist_ok=True)
    path.write_text(text)
