from launch import LaunchDescription
from launch.actions import GroupAction, SetLaunchConfiguration
from launch.substitutions import LaunchConfiguration
from launch_ros.actions import Node, PushRosNamespace, SetParameter, SetRemap


def node(name):
    return Node(package='demo', executable='x', name=[name, LaunchConfiguration('who')], namespace='own')


def generate_launch_description():
    return LaunchDescription([
        SetLaunchConfiguration('who', '_outer'),
        GroupAction([
            PushRosNamespace('robot'),
            SetLaunchConfiguration('who', '_inner'),
            SetRemap('scan', 'scan_filtered'),
            SetParameter('use_sim_time', True),
            node('a'),
            GroupAction([PushRosNamespace('/absolute'), node('b')]),
            GroupAction([PushRosNamespace('deep'), node('c')], scoped=False),
            node('d'),
        ]),
        node('e'),
        GroupAction([SetLaunchConfiguration('who', '_leaked')], scoped=False),
        node('f'),
        GroupAction([Node(package='demo', executable='x', name=LaunchConfiguration('who', default='gone'))],
                    forwarding=False),
        GroupAction([node('g')], launch_configurations={'who': '_passed'}),
    ])
