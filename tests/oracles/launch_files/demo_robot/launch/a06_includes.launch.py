import os

from ament_index_python.packages import get_package_share_directory
from launch import LaunchDescription
from launch.actions import DeclareLaunchArgument, GroupAction, IncludeLaunchDescription
from launch.launch_description_sources import PythonLaunchDescriptionSource
from launch.substitutions import LaunchConfiguration, PathJoinSubstitution, ThisLaunchFileDir
from launch_ros.actions import Node, PushRosNamespace
from launch_ros.substitutions import FindPackageShare


def generate_launch_description():
    share = get_package_share_directory('demo_robot')
    return LaunchDescription([
        DeclareLaunchArgument('rate', default_value='10'),
        IncludeLaunchDescription(
            PythonLaunchDescriptionSource(os.path.join(share, 'launch', 'part.launch.py')),
            launch_arguments={'name': 'first'}.items(),
        ),
        GroupAction([
            PushRosNamespace('second'),
            IncludeLaunchDescription(
                PythonLaunchDescriptionSource([ThisLaunchFileDir(), '/part.launch.py']),
                launch_arguments=[('name', 'second'), ('rate', LaunchConfiguration('rate'))],
            ),
        ]),
        IncludeLaunchDescription(PathJoinSubstitution([FindPackageShare('demo_robot'), 'launch', 'part.launch.py'])),
        Node(package='demo', executable='after', name=['after_', LaunchConfiguration('name')]),
    ])
