from launch import LaunchDescription
from launch.actions import DeclareLaunchArgument
from launch.conditions import IfCondition
from launch.substitutions import LaunchConfiguration
from launch_ros.actions import ComposableNodeContainer, LoadComposableNodes, PushRosNamespace, SetRemap
from launch_ros.descriptions import ComposableNode


def generate_launch_description():
    return LaunchDescription([
        DeclareLaunchArgument('extra', default_value='false'),
        PushRosNamespace('vision'),
        SetRemap('image', 'image_raw'),
        ComposableNodeContainer(
            name='container', namespace='', package='rclcpp_components', executable='component_container',
            composable_node_descriptions=[
                ComposableNode(package='demo', plugin='demo::A', name='a', remappings=[('in', 'out')],
                               parameters=[{'rate': 2}]),
                ComposableNode(package='demo', plugin='demo::Extra', name='extra',
                               condition=IfCondition(LaunchConfiguration('extra'))),
            ]),
        LoadComposableNodes(target_container='container', composable_node_descriptions=[
            ComposableNode(package='demo', plugin='demo::B', name='b', namespace='/own')]),
    ])
