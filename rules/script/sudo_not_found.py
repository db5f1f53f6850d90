"""sudo is to start what is not a program that it can find.

## What it finds
`sudo cd`, `sudo source`, `sudo export` and other words of the shell itself, and `sudo ros2` without `-i` or a `PATH`
of its own, in scripts. Silent where the message is thrown away or the failure is handled, and for `ros2` in trees
that change `secure_path`.

## Why it matters on a robot
sudo starts programs, and looks for them in the folders of `secure_path`, whatever the caller has sourced. The words of
the shell are not programs: the folder is not changed and the variable is not set. `ros2` is in `/opt/ros/<distro>/bin`,
where sudo does not look.

## Bad
```sh
sudo cd /opt/rover
sudo ros2 launch rover_bringup rover.launch.py
```

## Good
```sh
cd /opt/rover
ros2 launch rover_bringup rover.launch.py
```

## When to ignore it
When the sudoers file of the robot, which is not in the tree, adds the folder of ROS to `secure_path`.

## References
- sudoers(5), "secure_path"
- bash(1), "SHELL BUILTIN COMMANDS"
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Located
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import note
from bringup_lint.api import regex
from bringup_lint.api import rule
from bringup_lint.api.shell import Run

OF_THE_SHELL = ("cd", "source", ".", "export", "alias", "unset", "ulimit", "pushd", "popd", "shopt")
VALUED = ("-u", "-g", "-h", "-p", "-C", "-r", "-t", "-U", "-D", "-R")
SHELL = regex(r"-[a-zA-Z]*[is][a-zA-Z]*|--login|--shell")
OWN_PATH = regex(r"\bsecure_path\b|/usr/(?:local/)?bin/ros2\b|\balias[ \t]+sudo=")
PATH = "PATH="


@rule(
    "error",
    symptoms=["sudo: cd: command not found", "sudo: source: command not found", "sudo: ros2: command not found"],
)
def sudo_not_found(robot: Robot) -> Iterator[Finding]:
    for source in robot.of_kind("shell-script"):
        if not source.judged or "sudo " not in source.text:
            continue
        words = (_started(did) for did in robot.scripts.done(source) if isinstance(did, Run))
        found = [word for word in words if word is not None and _is_not_found(robot, word)]
        if found:
            first, *others = found
            yield finding(
                first,
                f"sudo does not find '{first}': {_why(first)}",
                advice=_advice(first),
                related=[note(other, "not found either") for other in others[:20]],
            )


def _started(run: Run) -> Located | None:
    """The word that sudo takes for its program; None where its own shell or path may know it."""
    words = run.command.words
    if not words or words[0] != "sudo" or run.command.hides_errors or run.command.ends == "||":
        return None
    at = 1
    while at < len(words) and (words[at].startswith("-") or "=" in words[at]):
        if SHELL.fullmatch(words[at]) or words[at].startswith(PATH):
            return None
        at += 2 if words[at] in VALUED else 1
    return words[at] if at < len(words) else None


def _is_not_found(robot: Robot, word: Located) -> bool:
    return word in OF_THE_SHELL or (word == "ros2" and not robot.mentions(OWN_PATH))


def _why(word: Located) -> str:
    if word == "ros2":
        return "it looks in the folders of secure_path, whatever setup file was sourced before"
    return "it is a word of the shell, and nothing is changed"


def _advice(word: Located) -> str:
    if word == "ros2":
        return "start ros2 without sudo, and give the user what it needs: a udev rule, a group, a capability"
    return f"write {word} without sudo, or sudo bash -c '{word} ...' with all that needs it"
