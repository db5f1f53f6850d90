from launch import LaunchDescription
from launch.actions import DeclareLaunchArgument, OpaqueFunction
from launch.substitutions import LaunchConfiguration
from launch_ros.actions import Node


def setup(context, prefix, suffix='x'):
    count = LaunchConfiguration('count').perform(context)
    nodes = []
    for index in range(3):
        nodes.append(Node(package='demo', executable='x', name=f'{prefix}_{index}_{count}_{suffix}'))
    if count == '2':
        nodes.append(Node(package='demo', executable='two', name='two'))
    elif count == '3':
        nodes.append(Node(package='demo', executable='three', name='three'))
    else:
        nodes.append(Node(package='demo', executable='more', name='more'))
    if context.launch_configurations['mode'] != 'real':
        return []
    return nodes


def generate_launch_description():
    return LaunchDescription([
        DeclareLaunchArgument('count', default_value='3'),
        DeclareLaunchArgument('mode', default_value='real'),
        OpaqueFunction(function=setup, args=['n'], kwargs={'suffix': 'y'}),
    ])
