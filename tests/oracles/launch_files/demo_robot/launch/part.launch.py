from launch import LaunchDescription
from launch.actions import DeclareLaunchArgument
from launch.substitutions import LaunchConfiguration
from launch_ros.actions import Node


def generate_launch_description():
    return LaunchDescription([
        DeclareLaunchArgument('name', default_value='nobody'),
        DeclareLaunchArgument('rate', default_value='1'),
        Node(package='demo', executable='part', name=LaunchConfiguration('name'),
             parameters=[{'rate': LaunchConfiguration('rate')}]),
    ])
