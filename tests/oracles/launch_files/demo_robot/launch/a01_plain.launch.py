from launch import LaunchDescription
from launch_ros.actions import Node


def generate_launch_description():
    return LaunchDescription([
        Node(package='demo', executable='talker', name='talker', namespace='chat', remappings=[('a', 'b'), ('c', '/d')]),
        Node(package='demo', executable='listener'),
    ])
