"""A service that counts on .bashrc for its ROS environment.

## What it finds
A service that starts ROS and sources no setup file, but reads a `.bashrc` or `.profile`, or starts its
shell as a login (`-l`) or interactive (`-i`) one. Also a service of a ROS tree that sources a `.bashrc`,
whatever it starts.

## Why it matters on a robot
systemd starts no login shell and reads no `.bashrc`. Sourcing it by hand does not help: the `.bashrc` of
Ubuntu and Debian returns in its first lines unless the shell is interactive, so the lines that `echo … >>
~/.bashrc` once added are never reached. A login shell reads `.profile`, which sources that same `.bashrc`
with the same result. `-i` gets through, and drags in prompts, aliases and job control without a terminal.
The launch works in every terminal and fails as a service.

## Bad
```ini
[Service]
ExecStart=/bin/bash -c 'source /home/rover/.bashrc && ros2 launch rover_bringup rover.launch.py'
```

## Good
```ini
[Service]
EnvironmentFile=/etc/rover/ros.env
ExecStart=/bin/bash -c 'source /opt/ros/jazzy/setup.bash && exec ros2 launch rover_bringup rover.launch.py'
```

## References
- bash(1), "INVOCATION"
- systemd.exec(5), "Environment Variables in Spawned Processes"
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import note
from bringup_lint.api import rule


@rule("warning", symptoms=["ros2: command not found", "No module named 'ros2cli'", "Package not found"])
def bashrc_only(robot: Robot) -> Iterator[Finding]:
    units = robot.units
    for unit in units.services:
        for process in units.started(unit):
            if not process.profiles or process.setup_files or not (process.mentions_ros or robot.is_ros):
                continue
            interactive = [
                word
                for _, word in process.profiles
                if word.startswith("-") and "i" in word.lstrip("-") and word != "--login"
            ]
            files = [(step, word) for step, word in process.profiles if not word.startswith("-")]
            if not process.ros and not files:
                continue
            step, word = files[0] if files else process.profiles[0]
            yield finding(
                interactive[0] if interactive else word,
                _message(unit, word, interactive),
                advice="source /opt/ros/<distro>/setup.bash and the workspace in ExecStart=, and keep variables in an "
                "EnvironmentFile=",
                related=[
                    *(note(process.program, f"{unit.name} starts it here") for _ in [0] if step.script),
                    *(note(ros.where, "needs the ROS environment") for _, ros in process.ros[:1]),
                ],
            )


def _message(unit, word, interactive):
    if interactive:
        return (
            f"{unit.name} takes its ROS environment from an interactive shell's .bashrc: "
            "prompts, aliases and job control come with it"
        )
    if word.startswith("-"):
        return (
            f"{unit.name} has no ROS environment: a login shell reads .profile, and .bashrc returns at once in a shell "
            "that is not interactive"
        )
    return f"{unit.name} gets no ROS environment from {word}: it returns at once in a shell that is not interactive"
