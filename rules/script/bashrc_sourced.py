"""A script appends to .bashrc, sources it, and relies on what it has appended.

## What it finds
A script that adds the setup file of ROS, or an `export`, to a `.bashrc`, sources that file, and then runs `ros2`,
`colcon` or the tools of ROS 1, or reads the variable, without setting it itself. In Dockerfiles: a build step that
sources the `.bashrc` of an Ubuntu image before `ros2` or `colcon`.

Silent where the shell is interactive, where the script or image changes the test for `PS1`, and where it sources a
setup file itself.

## Why it matters on a robot
The `.bashrc` of Ubuntu returns in its first lines unless the shell is interactive. What `echo ... >> ~/.bashrc` has
added is at its end, and is never reached: on a new robot, the build that follows finds neither ROS nor its packages.

## Bad
```sh
echo "source /opt/ros/jazzy/setup.bash" >> ~/.bashrc
source ~/.bashrc
colcon build
```

## Good
```sh
echo "source /opt/ros/jazzy/setup.bash" >> ~/.bashrc
source /opt/ros/jazzy/setup.bash
colcon build
```

## When to ignore it
When people source the script in a terminal, or the `.bashrc` is your own and has no early return.

## References
- bash(1), "INVOCATION"
- /etc/skel/.bashrc of Ubuntu and Debian
"""

import re
from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Located
from bringup_lint.api import NamedTuple
from bringup_lint.api import Robot
from bringup_lint.api import Source
from bringup_lint.api import finding
from bringup_lint.api import note
from bringup_lint.api import regex
from bringup_lint.api import rule
from bringup_lint.api.docker import Stage
from bringup_lint.api.docker import commands_of_run
from bringup_lint.api.docker import environment_of
from bringup_lint.api.docker import ubuntu_codename
from bringup_lint.api.shell import SHELLS
from bringup_lint.api.shell import Command
from bringup_lint.api.shell import Written
from bringup_lint.api.shell import commands
from bringup_lint.api.shell import shell_input
from bringup_lint.api.shell import unwrapped

BASHRC = regex(r"(?:~|\$HOME|\$\{HOME\}|/root|/home/[\w${}-]+)/\.bashrc|(?i:\$\{?\w{0,20}bashrc\w{0,20}\}?)")
ROS = "the environment of ROS"
READS = ("source", ".")
NEEDS_ROS = ("ros2", "colcon", "catkin_make", "catkin", "roslaunch", "rosrun")
SETUP = regex(r"(?:^|/)(?:local_)?setup\.(?:ba|z)?sh$", hints="setup.")
SOURCES_ROS = regex(r"\b(?:source|\.)[ \t]+\S{0,200}setup\.(?:ba|z)?sh", hints="setup.")
EXPORTS = regex(r"\bexport[ \t]+(?P<name>[A-Za-z_]\w*)=", hints="export")
INTERACTIVE = regex(
    r"\bPS1\b|\binteractive\b|^#![^\n]{0,60}[ \t]-[a-z]{0,4}[il]|\*i\*\)|\bbash[ \t]+-[a-z]{0,4}i", re.M
)
SETTLED = ("AMENT_PREFIX_PATH", "CMAKE_PREFIX_PATH", "ROS_ROOT")
USED = regex(r"\$\{?(?P<name>[A-Za-z_]\w*)")


class Lost(NamedTuple):
    """A `.bashrc` that gives nothing to the command that needs it."""

    read: Located
    needs: Located
    what: str
    added: Located | None


@rule(
    "warning",
    symptoms=['Could not find a package configuration file provided by "ament_cmake"'],
)
def bashrc_sourced(robot: Robot) -> Iterator[Finding]:
    for source in robot.of_kind("shell-script"):
        if (
            source.judged
            and source.text.startswith("#!")
            and source.matches(BASHRC)
            and not source.matches(INTERACTIVE)
        ):
            yield from _report(_in_script(robot, source))
    for file in robot.dockerfiles:
        if not file.source.matches(BASHRC) or file.source.matches(INTERACTIVE):
            continue
        for stage in file.stages:
            if ubuntu_codename(stage.origin) and not _is_set_up(stage):
                yield from _report(next(filter(None, map(_in_step, _steps(stage))), None))


def _report(lost: Lost | None) -> Iterator[Finding]:
    if lost is None:
        return
    related = [note(lost.needs, "needs it")]
    if lost.added is not None:
        related.append(note(lost.added, "added to the end of the file"))
    yield finding(
        lost.read,
        f"{lost.read} returns at once in a shell that is not interactive: {lost.what} is not set for {lost.needs}",
        advice="source the setup file itself, or set the variable here",
        related=related,
    )


def _in_script(robot: Robot, source: Source) -> Lost | None:
    """The first command that needs what a script has only added to the file."""
    pending = _Pending()
    for did in robot.scripts.done(source):
        if isinstance(did, Written):
            if did.path.endswith("/.bashrc") and did.text is not None:
                pending.add(str(did.text), did.where)
        elif "bashrc" in did.name:
            pending.add(" ".join(did.words[1:]), did.words[0])
        elif pending.is_unknown(did.command):
            return None
        elif lost := pending.needed_by(did.command):
            return lost
    return None


class _Pending:
    """What a script has added to the file and has not set itself."""

    def __init__(self) -> None:
        self.added: dict[str, Located] = {}
        self.settled: set[str] = set()
        self.read: Located | None = None

    def add(self, text: str, where: Located) -> None:
        names = [match["name"] for match in EXPORTS.finditer(text)]
        for name in [*names, *([ROS] if SOURCES_ROS.search(text) else [])]:
            if name not in self.settled:
                self.added.setdefault(name, where)

    def is_unknown(self, command: Command) -> bool:
        """Take in what a command sets; whether it may set anything."""
        words = unwrapped(command.words)
        for word in (*command.assignments, *words[1:]):
            self._settle(word.partition("=")[0])
        if not words or words[0] not in (*READS, "eval"):
            return False
        if len(words) > 1 and BASHRC.fullmatch(words[1]):
            self.read = words[1] if self.added else self.read
            return False
        if words[0] != "eval" and len(words) > 1 and SETUP.search(words[1]):
            self._settle(ROS)
            return False
        return True

    def _settle(self, name: str) -> None:
        self.settled.add(name)
        self.added.pop(name, None)

    def needed_by(self, command: Command) -> Lost | None:
        words = unwrapped(command.words)
        if self.read is None or not words or words[0] in READS:
            return None
        if words[0] in NEEDS_ROS and ROS in self.added:
            return Lost(self.read, words[0], ROS, self.added[ROS])
        for word in words:
            used = next((match["name"] for match in USED.finditer(word) if match["name"] in self.added), None)
            if used is not None:
                return Lost(self.read, word, used, self.added[used])
        return None


def _steps(stage: Stage) -> Iterator[list[Command]]:
    """The commands of each build step, with those that it gives to a shell."""
    for instruction in stage.all("RUN"):
        found: list[Command] = []
        for command in commands_of_run(instruction):
            read = shell_input(command.words[1:]) if command.name in SHELLS else None
            found += commands(read.text) if read is not None and read.text is not None else [command]
        yield found


def _in_step(step: list[Command]) -> Lost | None:
    """The first command that needs ROS from a file that returns at once."""
    read: Located | None = None
    for command in step:
        words = unwrapped(command.words)
        if words and words[0] in (*READS, "eval"):
            if len(words) > 1 and BASHRC.fullmatch(words[1]):
                read = words[1]
            else:
                return None
        elif words and words[0] in NEEDS_ROS and read is not None:
            return Lost(read, words[0], ROS, None)
    return None


def _is_set_up(stage: Stage) -> bool:
    """Whether the image itself has the variables of ROS, or a `.bashrc` of the tree."""
    copied = (each.value for one in stage.chain for each in one.all("COPY", "ADD"))
    return any(name in SETTLED for name, _ in environment_of(stage)) or any("bashrc" in value for value in copied)
