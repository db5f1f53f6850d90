from launch import LaunchDescription
from launch.actions import ExecuteProcess
from launch.actions import SetEnvironmentVariable


def generate_launch_description():
    return LaunchDescription(
        [
            ExecuteProcess(cmd=["/bin/sh", "-c", 'env > "$0"', "part"]),
            SetEnvironmentVariable("BASE", "changed"),
        ]
    )
