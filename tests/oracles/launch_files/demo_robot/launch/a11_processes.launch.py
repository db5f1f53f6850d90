import os

from launch import LaunchDescription
from launch.actions import ExecuteProcess, TimerAction
from launch.substitutions import TextSubstitution
from launch_ros.actions import Node


def generate_launch_description():
    here = os.path.dirname(os.path.realpath(__file__))
    return LaunchDescription([
        ExecuteProcess(cmd=['ros2', 'run', 'demo', 'talker', '--ros-args']),
        ExecuteProcess(cmd=['true']),
        TimerAction(period=1.0, actions=[Node(package='demo', executable='late', name='late')]),
        Node(package='demo', executable='here', parameters=[{'folder': os.path.basename('x/y')}]),
        Node(package='demo', executable='env', name=[TextSubstitution(text='un'), 'set']),
        Node(package='demo', executable='file', parameters=[os.path.join(here, '..', 'config', 'base.yaml')]),
    ])
