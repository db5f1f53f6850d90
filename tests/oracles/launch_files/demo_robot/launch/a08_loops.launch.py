from launch import LaunchDescription
from launch_ros.actions import Node

ROBOTS = [{'name': 'a', 'x': 1.0}, {'name': 'b', 'x': 2.0}]


def robot(name, x=0.0, **rest):
    return [Node(package='demo', executable='robot', name='robot_' + name, namespace=name, parameters=[{'x': x, **rest}])]


def generate_launch_description():
    ld = LaunchDescription()
    for each in ROBOTS:
        for action in robot(**each, y=3):
            ld.add_action(action)
    names = ','.join(each['name'] for each in ROBOTS)
    ld.add_action(Node(package='demo', executable='fleet', parameters=[{'names': names, 'n': len(ROBOTS)}]))
    for index, (left, right) in enumerate(zip(['l1', 'l2'], ['r1', 'r2'])):
        ld.add_action(Node(package='demo', executable='pair', name=f'{left}{right}{index}'))
    return ld
