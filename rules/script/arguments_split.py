"""An entry script splits the arguments that it hands on.

## What it finds
`$@`, `$*` or `${@}` without quotes as a whole command, or as a word of the command of `exec`, in the entry script of a
container: one that a Dockerfile or compose file names, or that is called `entrypoint`. Silent where it is for zsh or
sets IFS, and where the CMD of a Dockerfile that names it is one argument with a whole command line.

## Why it matters on a robot
The shell splits each argument at its blanks again, and replaces its patterns by the names of files. With
`command: bash -c "ros2 launch rover rover.launch.py"` bash runs `ros2` alone, and the container ends at once, or waits
with an error that names neither the script nor the quotes.

## Bad
```sh
source /opt/ros/jazzy/setup.bash
exec $@
```

## Good
```sh
source /opt/ros/jazzy/setup.bash
exec "$@"
```

## When to ignore it
When the container gets its whole command line as one argument, and is to split it.

## References
- bash(1), "Special Parameters", "Word Splitting"
- https://docs.docker.com/reference/dockerfile/#entrypoint
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import Source
from bringup_lint.api import finding
from bringup_lint.api import regex
from bringup_lint.api import rule
from bringup_lint.api.docker import Dockerfile
from bringup_lint.api.shell import Word
from bringup_lint.api.shell import shell_commands
from bringup_lint.api.shell import unwrapped

SPLITS_OTHERWISE = regex(r"\A#![^\n]*\bzsh\b|(?m:^[ \t]*(?:export[ \t]+)?IFS=\S+[ \t]*$)")
ARGUMENTS = ("$@", "$*", "${@}", "${*}")


@rule("warning", silent="the program gets other arguments, and says what it makes of those")
def arguments_split(robot: Robot) -> Iterator[Finding]:
    for source in robot.of_kind("shell-script"):
        if not source.judged or source.template or not any(each in source.text for each in ARGUMENTS):
            continue
        if SPLITS_OTHERWISE.search(source.text):
            continue
        word = next(_split(source), None)
        if word is None or any(_is_one_line(file, source) for file in robot.dockerfiles):
            continue
        if "entrypoint" in source.basename or robot.scripts.is_for_image(source):
            yield finding(
                word,
                "Each argument is split at its blanks again: what is one word for docker, such as the line after "
                "bash -c, comes as several",
                advice='write "$@"',
            )


def _is_one_line(file: Dockerfile, script: Source) -> bool:
    """Whether an image that takes the script has its command as one argument, which is to be split."""
    runs = file.final.last("CMD") if file.final is not None and script.basename in file.source.text else None
    return runs is not None and runs.exec_form is not None and len(runs.exec_form) == 1 and " " in runs.exec_form[0]


def _split(source: Source) -> Iterator[Word]:
    for command in shell_commands(source):
        words = unwrapped(command.words)
        if len(words) == 1 or command.name == "exec":
            found = (word for word in words if word in ARGUMENTS and isinstance(word, Word))
            yield from (word for word in found if not any(word.quotes))
