from launch import LaunchDescription
from launch.actions import DeclareLaunchArgument, GroupAction
from launch.conditions import IfCondition, LaunchConfigurationEquals, UnlessCondition
from launch.substitutions import LaunchConfiguration, PythonExpression
from launch_ros.actions import Node


def node(name, condition):
    return Node(package='demo', executable='x', name=name, condition=condition)


def generate_launch_description():
    sim, mode = LaunchConfiguration('sim'), LaunchConfiguration('mode')
    return LaunchDescription([
        DeclareLaunchArgument('sim', default_value='False'),
        DeclareLaunchArgument('mode', default_value='real'),
        node('a', IfCondition(sim)),
        node('b', UnlessCondition(sim)),
        node('c', IfCondition(PythonExpression(["'", mode, "' == 'real'"]))),
        node('d', IfCondition(PythonExpression(["'", mode, "' in ('mock', 'sim') or not ", sim]))),
        node('e', LaunchConfigurationEquals('mode', 'real')),
        GroupAction([node('f', UnlessCondition('0'))], condition=UnlessCondition(sim)),
        GroupAction([node('g', IfCondition('1'))], condition=IfCondition(sim)),
    ])
