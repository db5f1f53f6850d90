"""A command of ROS 2 over ssh has no ROS environment.

## What it finds
`ssh HOST 'ros2 ...'` in a script, where nothing before `ros2` in the remote command sources a setup file.

Silent where a variable, another script, a login or interactive shell or an environment of conda may do it, and where a
file of the tree sets up the environment of such shells (`BASH_ENV`, `/etc/environment`, ...).

## Why it matters on a robot
ssh gives the command to a shell that is not interactive. Ubuntu's `.bashrc` returns at its start in such a shell,
before the lines that source ROS: `ros2: command not found`. By hand it works, because an interactive login reads the
whole file.

## Bad
```sh
ssh rover@10.0.0.5 'ros2 service call /stand std_srvs/srv/Trigger'
```

## Good
```sh
ssh rover@10.0.0.5 'source /opt/ros/humble/setup.bash && ros2 service call /stand std_srvs/srv/Trigger'
```

## When to ignore it
When the robot's `.bashrc` sources ROS before it looks whether the shell is interactive, or `/etc/environment` has the
variables.

## References
- bash(1), "INVOCATION"; sshd(8), "LOGIN PROCESS"
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Located
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import regex
from bringup_lint.api import rule
from bringup_lint.api.shell import Run

BARE = regex(
    r"(?:^|&&|\|\||;)[ \t]*(?:(?:exec|nohup|timeout[ \t]+[\w.]+)[ \t]+)*ros2[ \t]+"
    r"(?:launch|run|topic|service|node|param|action|bag|lifecycle|daemon|control|doctor|pkg)\b"
)
MAY_SOURCE = regex(
    r"\bsource\b|setup\.|(?:^|[ \t;&])\.[ \t]|^[;&|]|sh\b|AMENT_|[$`/\"']|activate\b"
    r"|\b(?:docker|podman|distrobox|pixi|nix|direnv)\b"
)

SETS_UP = regex(r"\bBASH_ENV\b|/etc/environment|\bzshenv|UserEnvironment|\.ssh/environment|/bin/ros2\b|sed -i [\"']?1")
EARLIER = regex(r"\bsource\b|setup\.|[;&]$|^-o|=")


@rule("warning", symptoms=["bash: ros2: command not found"])
def ros_over_ssh(robot: Robot) -> Iterator[Finding]:
    for _, run in robot.scripts.run("ssh"):
        text = _bare(run)
        if text is not None and not robot.mentions(SETS_UP):
            yield finding(
                text,
                "The shell of an ssh command is not interactive and has no ROS environment: ros2 is not found",
                advice="begin the remote command with 'source /opt/ros/<distro>/setup.bash && '",
                confidence="medium",
            )


def _bare(run: Run) -> Located | None:
    """The word of a remote command that starts ros2 before anything may have sourced a setup file."""
    if run.words[2:3] == ("ros2",) and not run.words[1].startswith("-"):
        return run.words[2]
    for word in run.words[1:]:
        found = BARE.search(word)
        if found is not None:
            earlier = any(map(EARLIER.search, run.words[1 : run.words.index(word)]))
            return word if not earlier and not MAY_SOURCE.search(word[: found.end()]) else None
    return None
