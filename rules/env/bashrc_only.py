"""A service relies on .bashrc for its ROS environment.

## What it finds
A service that starts ROS without a setup file, and instead reads a `.bashrc` or `.profile`, or starts its shell as
a login (`-l`) or interactive (`-i`) shell. In a ROS tree, every service that sources a `.bashrc` is reported,
whatever it starts. An interactive shell reads the file and works: it is an info.

## Why it matters on a robot
systemd does not start a login shell and does not read `.bashrc`. Sourcing it by hand does not help: the `.bashrc`
of Ubuntu and Debian returns in its first lines unless the shell is interactive, so it never reaches the lines that
`echo … >> ~/.bashrc` once added. A login shell reads `.profile`, which sources the same `.bashrc` with the same
result. `-i` works, but brings prompts, aliases and job control without a terminal. The launch works in every
terminal and fails as a service.

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

## When to ignore it
When the `.bashrc` is your own, has no early return and is installed with the robot. A separate file with a clear
name is still better.

## References
- bash(1), "INVOCATION"
- systemd.exec(5), "Environment Variables in Spawned Processes"
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Located
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import note
from bringup_lint.api import rule
from bringup_lint.api.systemd import Process
from bringup_lint.api.systemd import Unit


@rule("warning", symptoms=["No module named 'ros2cli'", "Package not found", "ros2: command not found"])
def bashrc_only(robot: Robot) -> Iterator[Finding]:
    units = robot.units
    for unit in units.services:
        for process in units.started(unit):
            if (
                not process.profiles
                or process.setup_files
                or not (process.mentions_ros or process.plans_ros or robot.is_ros)
            ):
                continue
            if _sources_unknown(process):
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
                severity="info" if interactive or (not process.ros and _needs_nothing(process)) else None,
                related=[
                    *(note(process.program, f"{unit.name} starts it here") for _ in [0] if step.script),
                    *(note(ros.where, "needs the ROS environment") for _, ros in process.ros[:1]),
                ],
            )


def _needs_nothing(process: Process) -> bool:
    """Whether all scripts that are started are known, and have nothing to do with ROS."""
    is_known = process.script_outside_tree is None and any(step.script is not None for step in process.steps)
    return is_known and not process.mentions_ros


def _sources_unknown(process: Process) -> bool:
    """Whether a file that is sourced, or a text that is evaluated, may set up ROS: what it says is not known."""
    profiles = {word for _, word in process.profiles}
    for step in process.steps:
        command = step.command
        if command.name == "eval":
            return True
        if command.name in ("source", ".") and len(command.words) > 1 and command.words[1] not in profiles:
            if not any(other.script is not None for other in process.steps) or "$" in command.words[1]:
                return True
    return False


def _message(unit: Unit, word: Located, interactive: list[Located]) -> str:
    if interactive:
        return (
            f"{unit.name} takes its ROS environment from the .bashrc of an interactive shell, "
            "with its prompts, aliases and job control"
        )
    if word.startswith("-"):
        return (
            f"{unit.name} has no ROS environment: a login shell reads .profile, and .bashrc returns at once in a shell "
            "that is not interactive"
        )
    return f"{unit.name} gets no ROS environment from {word}: it returns at once in a shell that is not interactive"
