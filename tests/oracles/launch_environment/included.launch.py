import os

from launch import LaunchDescription
from launch.actions import DeclareLaunchArgument
from launch.actions import ExecuteProcess
from launch.actions import IncludeLaunchDescription
from launch.actions import OpaqueFunction
from launch.actions import SetEnvironmentVariable
from launch.launch_description_sources import PythonLaunchDescriptionSource
from launch.substitutions import LaunchConfiguration
from launch.substitutions import ThisLaunchFileDir


def more(context):
    domain = LaunchConfiguration("domain").perform(context)
    return [
        SetEnvironmentVariable("FROM_CODE", domain + "0"),
        ExecuteProcess(cmd=["/bin/sh", "-c", 'env > "$0"', "opaque"]),
    ]


def generate_launch_description():
    os.environ["AT_LOAD"] = "yes"
    return LaunchDescription(
        [
            DeclareLaunchArgument("domain", default_value="5"),
            SetEnvironmentVariable(name="ROS_DOMAIN_ID", value=LaunchConfiguration("domain")),
            IncludeLaunchDescription(PythonLaunchDescriptionSource([ThisLaunchFileDir(), "/part.launch.py"])),
            ExecuteProcess(cmd=["/bin/sh", "-c", 'env > "$0"', "behind"]),
            OpaqueFunction(function=more),
            ExecuteProcess(cmd=["/bin/sh", "-c", 'env > "$0"', "end"]),
        ]
    )
