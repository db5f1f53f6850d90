from launch import LaunchDescription
from launch_ros.actions import Node


def generate_launch_description():
    return LaunchDescription(
        [
            Node(package="otter_sonar", executable="sonar", name="sonar", namespace="bow"),
            Node(package="otter_survey", executable="mapper", name="mapper"),
            Node(package="otter_survey", executable="planner", name="planner"),
            Node(package="otter_base", executable="thrusters", name="thrusters"),
        ]
    )
