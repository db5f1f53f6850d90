"""An Exec line starts with ros2 or a shell keyword, which systemd cannot find.

## What it finds
An Exec line whose first word systemd cannot run:

- a program outside of systemd's search path, such as ros2, colcon, rviz2 or rosrun (not checked with
  ExecSearchPath=);
- a word that only a shell knows, such as source, export or cd.

## Why it matters on a robot
The service fails at once with status 203/EXEC. Even the full path of ros2 would not help, because nothing has
sourced the ROS setup file.

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

## When to ignore it
When ros2 is a wrapper script in a folder of systemd's search path, such as /usr/local/bin. Never for shell
keywords.

## References
- systemd.service(5), "Command lines": the search path is fixed when systemd is built
- journal: "Failed to locate executable ros2: No such file or directory"
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Fix
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import fix
from bringup_lint.api import rule
from bringup_lint.api.systemd import Command

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


@rule(
    "error",
    fix="unsafe",
    symptoms=[
        "status=203/EXEC",
        "Failed to locate executable",
        "Failed at step EXEC spawning ros2: No such file or directory",
        "is not executable",
    ],
)
def exec_bare_ros2(robot: Robot) -> Iterator[Finding]:
    for line in robot.units.lines:
        for command in line.commands:
            program = command.program
            if program in _SHELL_WORDS:
                message = f"'{program}' is a shell command, and systemd runs no shell: the service fails to start"
                yield finding(program, message, advice="put the whole line into /bin/bash -c '...'")
            elif program in _PROGRAMS and not any(other.key == "ExecSearchPath" for other in line.file.assignments):
                message = f"'{program}' is not in systemd's search path, and nothing sources the ROS setup file"
                advice = f"write /bin/bash -c 'source <setup.bash> && exec {program} ...'"
                yield finding(program, message, advice=advice, fix=_wrapped(robot, command))


def _wrapped(robot: Robot, command: Command) -> Fix | None:
    text = command.where.span.text
    if robot.target.ros is None or command.prefixes or {"'", "\\", "\n"} & set(text):
        return None
    setup = f"/opt/ros/{robot.target.ros}/setup.bash"
    return fix(
        "source the setup file in a shell",
        (command.where, f"/bin/bash -c 'source {setup} && exec {text}'"),
        safe=False,
    )
