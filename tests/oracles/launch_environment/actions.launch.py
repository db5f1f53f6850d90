from launch import LaunchDescription
from launch.actions import AppendEnvironmentVariable
from launch.actions import ExecuteProcess
from launch.actions import GroupAction
from launch.actions import PopEnvironment
from launch.actions import PushEnvironment
from launch.actions import ResetEnvironment
from launch.actions import SetEnvironmentVariable
from launch.actions import TimerAction
from launch.actions import UnsetEnvironmentVariable
from launch.conditions import IfCondition
from launch.substitutions import EnvironmentVariable


def probe(name, **options):
    return ExecuteProcess(cmd=["/bin/sh", "-c", 'env > "$0"', name], **options)


def generate_launch_description():
    return LaunchDescription(
        [
            probe("first"),
            SetEnvironmentVariable("ROS_DOMAIN_ID", "42"),
            SetEnvironmentVariable(
                "COPY", [EnvironmentVariable("BASE"), "/", EnvironmentVariable("NOWHERE", default_value="x")]
            ),
            probe("set", additional_env={"ONE": "1", "ROS_DOMAIN_ID": "7"}),
            probe("alone", env={"ONE": "2", "TWO": EnvironmentVariable("BASE")}, additional_env={"THREE": "3"}),
            AppendEnvironmentVariable("LIST", "back"),
            AppendEnvironmentVariable("LIST", "front", prepend=True, separator=";"),
            AppendEnvironmentVariable("FRESH", "only"),
            probe("list", additional_env={"READ": EnvironmentVariable("COPY")}),
            GroupAction(
                [SetEnvironmentVariable("ROS_DOMAIN_ID", "8"), UnsetEnvironmentVariable("BASE"), probe("inside")]
            ),
            GroupAction([probe("forgets"), SetEnvironmentVariable("ONE", "4"), probe("own")], forwarding=False),
            GroupAction([SetEnvironmentVariable("LEAKS", "yes")], scoped=False),
            probe("outside"),
            PushEnvironment(),
            ResetEnvironment(),
            SetEnvironmentVariable("ONE", "5"),
            probe("reset"),
            PopEnvironment(),
            SetEnvironmentVariable("NEVER", "x", condition=IfCondition("false")),
            SetEnvironmentVariable("ALWAYS", "x", condition=IfCondition("true")),
            probe("popped"),
            GroupAction(
                [
                    SetEnvironmentVariable("ROS_DOMAIN_ID", "9"),
                    TimerAction(period=0.1, actions=[SetEnvironmentVariable("LATE", "l"), probe("late")]),
                ]
            ),
            probe("with_exit", on_exit=[probe("after")]),
            SetEnvironmentVariable("ROS_DOMAIN_ID", "10"),
        ]
    )
