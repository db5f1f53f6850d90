from launch import LaunchDescription
from launch.actions import DeclareLaunchArgument
from launch.substitutions import LaunchConfiguration, PathJoinSubstitution
from launch_ros.actions import Node
from launch_ros.parameter_descriptions import ParameterFile, ParameterValue
from launch_ros.substitutions import FindPackageShare


def generate_launch_description():
    config = PathJoinSubstitution([FindPackageShare('demo_robot'), 'config', 'base.yaml'])
    return LaunchDescription([
        DeclareLaunchArgument('params', default_value=config),
        DeclareLaunchArgument('flag', default_value='true'),
        Node(package='demo', executable='a', parameters=[config, {'nested': {'a': 1, 'b': {'c': 'd'}}}]),
        Node(package='demo', executable='b', parameters=[LaunchConfiguration('params'), ParameterFile(config)]),
        Node(package='demo', executable='c', parameters=[{
            'flag': LaunchConfiguration('flag'),
            'word': ParameterValue(LaunchConfiguration('flag'), value_type=str),
            'number': '5',
        }]),
    ])
