from launch import LaunchDescription
from launch.actions import DeclareLaunchArgument
from launch.substitutions import LaunchConfiguration
from launch_ros.actions import Node


def generate_launch_description():
    return LaunchDescription([
        DeclareLaunchArgument('prefix', default_value=''),
        Node(package='demo', executable='base', name=['x', LaunchConfiguration('prefix', default='never'), 'y']),
    ])
