"""An Exec line starts ros2 or a shell word, which systemd cannot find.

## What it finds
A first word such as ros2, colcon, rviz2 or rosrun, which lie outside systemd's search path, or source,
export, cd and other words that only a shell knows. With ExecSearchPath= the names of programs are not
judged.

## Why it matters on a robot
The service fails at once with status 203/EXEC. And nothing has sourced the ROS set-up, so the full path of
ros2 alone would not help either.

## Bad
```ini
[Service]
ExecStart=ros2 launch robot_bringup bringup.launch.py
```

## Good
```ini
[Service]
ExecStart=/bin/bash -c 'source /opt/ros/jazzy/setup.bash && exec ros2 launch robot_bringup bringup.launch.py'
```

## References
- systemd.service(5), "Command lines": the search path is fixed when systemd is built
- journal: "Failed to locate executable ros2: No such file or directory"
"""

from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import fix
from bringup_lint.api import rule

_PROGRAMS = ("ros2", "colcon", "rviz2", "rosrun", "roslaunch", "roscore", "gz", "ign")
_SHELL_WORDS = (
    "source",
    ".",
    "export",
    "cd",
    "eval",
    "exec",
    "set",
    "unset",
    "alias",
    "ulimit",
    "exit",
    "if",
    "while",
)


@rule("error", fix="unsafe", symptoms=["status=203/EXEC", "Failed to locate executable", "is not executable"])
def exec_bare_ros2(robot: Robot):
    for line in robot.units.lines:
        searched = any(other.key == "ExecSearchPath" for other in line.file.assignments)
        for command in line.commands:
            program = command.program
            if program in _SHELL_WORDS:
                message = f"'{program}' is a word of the shell, and systemd runs no shell: the service fails to start"
                yield finding(program, message, advice="put the whole line into /bin/bash -c '...'")
            elif program in _PROGRAMS and not searched:
                message = f"'{program}' is not in systemd's search path, and nothing sources the ROS set-up"
                advice = f"write /bin/bash -c 'source <setup.bash> && exec {program} ...'"
                yield finding(program, message, advice=advice, fix=_wrapped(robot, command))


def _wrapped(robot, command):
    text = command.where.span.text
    if robot.target.ros is None or command.prefixes or {"'", "\\", "\n"} & set(text):
        return None
    setup = f"/opt/ros/{robot.target.ros}/setup.bash"
    return fix(
        "source the set-up in a shell",
        (command.where, f"/bin/bash -c 'source {setup} && exec {text}'"),
        safe=False,
    )
