from launch import LaunchDescription
from launch_ros.actions import LifecycleNode, Node

DEBUG = False
LEVELS = {'camera': 'info', 'lidar': 'debug'}


def generate_launch_description():
    nodes = [LifecycleNode(package='demo', executable='arm', name='arm', namespace='left')]
    if DEBUG:
        nodes.append(Node(package='demo', executable='debugger'))
    elif 'camera' in LEVELS and not DEBUG:
        nodes += [Node(package='demo', executable=key, name=f'{key}_{value}') for key, value in LEVELS.items() if value != 'off']
    first, *rest = ['x', 'y']
    nodes.extend([Node(package='demo', executable='z', name='a' if len(nodes) > 2 else 'b')])
    return LaunchDescription([*nodes, Node(package='demo', executable='{}_{}'.format('q', 1), name='%s_%s' % ('r', 's'))])
