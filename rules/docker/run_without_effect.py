"""A build step only changes the shell that it ends with.

## What it finds
A `RUN` that does nothing but `source` a file, `export` variables, `cd` or define an `alias`, and one that ends with an
`export`. And a variable that one `RUN` sets and a later one reads, which neither ENV nor ARG nor the later step sets,
nor what that sources. One finding for each stage. A file that is sourced for nothing is an info where no later step of
the stage calls anything of ROS without a setup file of its own, and so is a folder that is entered where nothing after
it is relative to it.

## Why it matters on a robot
Every RUN has a shell of its own, and nothing of its environment is in the image: the next step builds without the
sourced workspace, and nodes in the container start without the exported variables.

## Bad
```dockerfile
RUN source /opt/ros/jazzy/setup.bash
RUN colcon build
```

## Good
```dockerfile
RUN . /opt/ros/jazzy/setup.sh && colcon build
```

## When to ignore it
When the step only proves that the file can be read.

## References
- https://docs.docker.com/reference/dockerfile/#run
- https://docs.docker.com/reference/dockerfile/#environment-replacement: ENV stays in the image
"""

import re
from bisect import bisect_right
from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Located
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import note
from bringup_lint.api import regex
from bringup_lint.api import rule
from bringup_lint.api.docker import Instruction
from bringup_lint.api.docker import Stage
from bringup_lint.api.docker import commands_of_run
from bringup_lint.api.docker import environment_of
from bringup_lint.api.docker import may_set
from bringup_lint.api.shell import Command

OF_THE_SHELL = ("source", ".", "export", "cd", "alias", "unset")
OF_ROS = regex(r"\b(?:colcon|ros2|ament_\w+|cmake|rosdep[ \t]+install|ROS_DISTRO)\b")
"""What a step needs the environment of a workspace for."""
FROM_HERE = regex(
    r"(?:^|[\s=\"'])(?:\.{1,2}(?=[/\s]|$)|[\w.-]+/|[\w-]+\.(?:sh|bash|py|txt)\b)|\b(?:make|cmake|colcon|catkin|npm|yarn|cargo)\b"
    r"|\bgit\b(?!\s+(?:clone|-C)\b)"
)
"""A relative path in a command line, or a program that works on the folder in which it is started."""
NAME = regex(r"([A-Za-z_]\w*)\+?=")
SETS = "read|readarray|mapfile|getopts|printf|for|local"
"""Words of the shell before a variable that they set."""
USED = regex(r"(?<![\\$])\$\{?([A-Za-z_]\w*)\b(?![:\[]?[-=+?])", hints="$")
LITERAL = regex(r"(?P<literal>'[^']*')|\"(?:\\[\s\S]|[^\"\\])*\"|\\[\s\S]")
"""What is quoted; nothing is replaced between single quotes."""
ALWAYS = "PATH HOME HOSTNAME PWD OLDPWD IFS OPTIND PPID SHLVL UID EUID RANDOM SECONDS LINENO PS1 PS2 PS4".split()
"""Variables that docker or each shell sets by itself."""
SETUP = regex(r"setup\.\w{0,2}sh[\"']?$")
STARTS = ("RUN", "CMD", "ENTRYPOINT")
BUILDS = regex(r"\b(?:colcon|ros2|ament_\w+|cmake)\b")
"""The same where the image knows ROS_DISTRO by itself."""
ADVICE = {
    "source": "join it with the step that needs it: RUN . FILE && ...",
    ".": "join it with the step that needs it: RUN . FILE && ...",
    "export": "write ENV NAME=value",
    "cd": "write WORKDIR",
}


@rule("warning", symptoms=["/bin/sh: *: ros2: not found"])
def run_without_effect(robot: Robot) -> Iterator[Finding]:
    for file in robot.dockerfiles:
        for stage in file.stages:
            found = list(_lost(stage))
            yield from _read_later(stage, found)
            if not found:
                continue
            first, later = found[0], _Later(stage)
            yield finding(
                first.words[0],
                f"'{first.name}' changes only the shell of this step: nothing of it is left in the next one",
                advice=ADVICE.get(first.name, "join it with the step that needs it"),
                related=[note(other.words[0], "this step too") for other in found[1:]],
                severity="info" if all(map(later.is_idle, found)) else None,
            )


def _lost(stage: Stage) -> Iterator[Command]:
    """The first command of every RUN that has commands of the shell itself only, and an export that ends one."""
    for instruction in stage.all("RUN"):
        commands = [] if instruction.exec_form else list(commands_of_run(instruction))
        if commands and all(_only_of_shell(command) for command in commands):
            yield commands[0]
        elif commands and commands[-1].name == "export" and len(commands[-1].words) > 1:
            yield commands[-1]


def _read_later(stage: Stage, lost: list[Command]) -> Iterator[Finding]:
    """The first reading of each variable that only an earlier step has set."""
    known = {name for name, _ in environment_of(stage)}
    arguments = (word for one in stage.chain for each in one.all("ARG") for word in each.value.words())
    known.update(ALWAYS, (str(word).partition("=")[0] for word in arguments))
    ended = {word.span for command in lost for word in command.words}
    before: dict[str, Located] = {}
    for instruction in stage.all("RUN"):
        if instruction.exec_form:
            continue
        own = dict(_set_by(instruction))
        if before and not _sources(instruction):
            yield from _empty(instruction, own, before)
        for name, word in own.items():
            if name not in known and word.span not in ended and (name.islower() or not may_set(stage.origin, name)):
                before.setdefault(name, word)


def _empty(instruction: Instruction, own: dict[str, Located], before: dict[str, Located]) -> Iterator[Finding]:
    """What a step reads of the variables of earlier ones, each of which is taken out."""
    for script in instruction.scripts:
        for match in _replaced(script):
            name = match[1]
            place = before.pop(name, None)
            if place is None or name in own:
                continue
            if not re.search(rf"\b(?:{SETS})\b[^\n;|&]*\b{re.escape(name)}\b", script):
                yield finding(
                    script.part(*match.span()),
                    f"{name} is empty here: each RUN has a shell of its own, and an earlier one has set it",
                    advice="join the two steps with &&, or set it with ENV or ARG",
                    related=[note(place, "set in the shell of this step")],
                )


def _replaced(script: Located) -> Iterator[re.Match[str]]:
    """Where a shell puts in the value of a variable."""
    plain = LITERAL.sub(lambda match: " " * len(match[0]) if match["literal"] else match[0], script)
    quotes = last = 0
    for match in USED.finditer(plain):
        quotes += plain.count("'", last, match.start())
        last = match.start()
        if quotes % 2 == 0:
            yield match


def _sources(instruction: Instruction) -> bool:
    """Whether a step reads a file that may set anything: a setup file of ROS does not."""
    return any(
        command.name == "eval" or (command.name in ("source", ".") and not SETUP.search(command.words[-1]))
        for command in commands_of_run(instruction)
    )


def _set_by(instruction: Instruction) -> Iterator[tuple[str, Located]]:
    """The variables that the shell of a step sets, with the words that do."""
    for command in commands_of_run(instruction):
        words = command.words[1:] if command.name in ("export", "declare", "readonly") else ()
        for word in (*words, *(() if command.words else command.assignments)):
            if match := NAME.match(word):
                yield match[1], word


class _Later:
    """What the steps of a stage do, from each of them on, with the folder and the environment in which they start."""

    def __init__(self, stage: Stage) -> None:
        self._starts = [each.keyword.span.start for each in stage.instructions]
        here, ros, builds = False, False, False
        found = [(here, ros, builds)]
        for each in reversed(stage.instructions):
            text = "\n".join([each.value, *each.heredocs])
            here = each.name != "WORKDIR" and (here or (each.name in STARTS and FROM_HERE.search(text) is not None))
            if each.name == "RUN" and "setup." not in text:
                ros, builds = ros or OF_ROS.search(text) is not None, builds or BUILDS.search(text) is not None
            found.append((here, ros, builds))
        self._found = found[::-1]

    def is_idle(self, lost: Command) -> bool:
        """Whether a file is sourced, and no step after it would find anything of ROS in its environment, or a folder is
        entered to which none of them refers."""
        here, ros, builds = self._found[bisect_right(self._starts, lost.words[0].span.start)]
        if lost.name == "cd":
            return not here
        if lost.name not in ("source", "."):
            return False
        return not (builds if "ROS_DISTRO" in " ".join(lost.words) else ros)


def _only_of_shell(command: Command) -> bool:
    if any(redirect.writes for redirect in command.redirects) or "$(" in " ".join(command.words):
        return False
    return command.name in OF_THE_SHELL and not command.depth
