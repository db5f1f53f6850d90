"""A command is an argument of the installer before it.

## What it finds
`apt-get`, `pip` or `rosdep` in a shell script or in the `RUN` of a Dockerfile, with another command among its
arguments, such as `pip cache purge`, `apt-get install`, `rm -rf`, `git clone`, `colcon build`: a line ends with a
backslash, and `&&` or `;` is missing.

## Why it matters on a robot
pip looks for packages called "pip", "cache" and "purge", and installs what strangers have registered under such names.
apt-get ends with "Unable to locate package", or removes what was to be installed. The second command never runs.

## Bad
```dockerfile
RUN pip install pyserial==3.5 \
    pip cache purge
```

## Good
```dockerfile
RUN pip install pyserial==3.5 \
    && pip cache purge
```

## When to ignore it
Never.

## References
- POSIX, Shell Command Language, "Lists"
"""

from collections.abc import Iterable
from collections.abc import Iterator
from itertools import pairwise

from bringup_lint.api import Finding
from bringup_lint.api import Located
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import regex
from bringup_lint.api import rule
from bringup_lint.api.docker import commands_of
from bringup_lint.api.shell import Command
from bringup_lint.api.shell import program_name
from bringup_lint.api.shell import shell_commands
from bringup_lint.api.shell import unwrapped

INSTALLERS = ("apt", "apt-get", "pip", "pip3", "rosdep")
STEPS = ("install", "update", "upgrade", "clean", "autoremove", "remove", "purge", "cache", "init")
FOLLOWERS = {
    **dict.fromkeys(INSTALLERS, STEPS),
    "rm": ("-r", "-f", "-rf", "-fr"),
    "git": ("clone", "checkout", "submodule"),
    "colcon": ("build",),
    "vcs": ("import",),
    "mkdir": ("-p",),
    "sudo": INSTALLERS,
}
"""Command -> the words that show that it is one."""
HINT = regex(r"\\\r?\n", hints="\\")


@rule("error", symptoms=["E: Unable to locate package install", "ERROR: No matching distribution found for cache"])
def separator_missing(robot: Robot) -> Iterator[Finding]:
    for source in robot.of_kind("shell-script"):
        if source.judged and not source.template and HINT.search(source.text):
            yield from _findings(shell_commands(source))
    for file in robot.dockerfiles:
        for stage in file.stages:
            yield from _findings(commands_of(stage))


def _findings(commands: Iterable[Command]) -> Iterator[Finding]:
    for command in commands:
        words = unwrapped(command.words)
        name = program_name(words[0]) if words else ""
        swallowed = _swallowed(words[1:]) if name in INSTALLERS else None
        if swallowed is not None:
            word, following = swallowed
            yield finding(
                word,
                f"'{word} {following}' is an argument of {name}: it does not run, and {name} takes it for its own",
                advice=f"write && before {word}",
            )


def _swallowed(words: tuple[Located, ...]) -> tuple[Located, Located] | None:
    """The first two words of a command among the arguments of another."""
    for word, following in pairwise(words[1:]):
        if following in FOLLOWERS.get(word, ()) and word.span.text == word:
            return word, following
    return None
