from launch import LaunchDescription
from launch.actions import DeclareLaunchArgument
from launch.substitutions import LaunchConfiguration
from launch_ros.actions import Node


def generate_launch_description():
    robot = LaunchConfiguration('robot')
    return LaunchDescription([
        DeclareLaunchArgument('robot', default_value='rover'),
        DeclareLaunchArgument('name', default_value=[robot, '_base']),
        Node(package='demo', executable='base', name=LaunchConfiguration('name'), namespace=robot,
             parameters=[{'frame': [robot, '/base'], 'rate': 5, 'list': [1, 2], 'mixed': [1, 2.5]}]),
        Node(package='demo', executable='other', name=LaunchConfiguration('other', default='fallback')),
    ])
