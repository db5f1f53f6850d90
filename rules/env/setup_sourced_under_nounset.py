"""A setup file is sourced with set -u.

## What it finds
`source .../setup.bash` in a script, or in the text after `bash -c` of a unit, a container or a cron job, after
`set -u`, `set -eu...` or `set -o nounset`, without a `set +u` in between. A script that begins with `#!/bin/bash -u`
counts, too. Only setup files below `/opt/ros/`, `install/` and `devel/` count, because another `setup.sh` may be
anything. Silent if the script sets AMENT_TRACE_SETUP_FILES or COLCON_TRACE.

## Why it matters on a robot
The ROS setup files read variables that are not set: the script exits there, and the service with it.

## Bad
```sh
set -euo pipefail
source /opt/ros/jazzy/setup.bash
```

## Good
```sh
set -eo pipefail
source /opt/ros/jazzy/setup.bash
set -u
```

## When to ignore it
When the environment of the script always sets AMENT_TRACE_SETUP_FILES.

## References
- bash(1), "set -u"
- ament_package, `prefix_level/setup.sh`: reads AMENT_TRACE_SETUP_FILES; colcon-bash, `prefix.bash.em`: COLCON_TRACE
"""

from collections.abc import Iterable
from collections.abc import Iterator
from itertools import pairwise
from itertools import takewhile

from bringup_lint.api import Finding
from bringup_lint.api import Located
from bringup_lint.api import Robot
from bringup_lint.api import Source
from bringup_lint.api import finding
from bringup_lint.api import note
from bringup_lint.api import regex
from bringup_lint.api import rule
from bringup_lint.api.shell import SHELLS
from bringup_lint.api.shell import Command
from bringup_lint.api.shell import program_name
from bringup_lint.api.shell import shell_commands
from bringup_lint.api.shell import unwrapped

SETUP = regex(r"(?:^|/)(?:opt/ros/[^/]+|install|install_\w+|devel)/(?:local_)?setup\.(?:bash|sh)$")
"""The files of a distribution or of a built workspace; another setup.sh may be anything."""

TRACE = regex(r"(?:\$\{)?(?:AMENT_TRACE_SETUP_FILES|COLCON_TRACE):?=")
"""What sets the variable that the setup files of a distribution, or of a workspace, read first."""
_SHEBANG = regex(r"#![^\n]{0,80}sh[ \t]+-\w{0,9}u\w{0,9}\b", hints="#!")
_ON, _OFF = regex(r"-[a-zA-Z]*u[a-zA-Z]*"), regex(r"\+[a-zA-Z]*u[a-zA-Z]*")


@rule(
    "error",
    symptoms=[
        "AMENT_TRACE_SETUP_FILES: unbound variable",
        "COLCON_TRACE: unbound variable",
        "setup.bash: line *: unbound variable",
    ],
)
def setup_sourced_under_nounset(robot: Robot) -> Iterator[Finding]:
    if not robot.may_hold("setup."):
        return
    for source in robot.of_kind("shell-script"):
        if source.judged and not source.template and "setup." in source.said:
            yield from _check(shell_commands(source), _shebang(source), "the script exits here")
    runners = [each for each in robot.runners.all if each.source.kind != "shell-script"]
    for line in {line.line.span: line for runner in runners for line in runner.lines}.values():
        own = [step.command for step in line.steps if step.script is None and step.shell]
        yield from _check(own, _option(line.argv), "the shell ends here, and what follows is not started")


def _shebang(source: Source) -> Located | None:
    found = _SHEBANG.match(source.text)
    return source.located(0, found.end()) if found is not None else None


def _option(argv: tuple[Located, ...]) -> Located | None:
    """The option by which a shell is started so."""
    words = unwrapped(argv)
    if not words or program_name(words[0]) not in SHELLS:
        return None
    options = takewhile(lambda word: word.startswith("-") or word in ("pipefail", "nounset"), words[1:])
    return _switch((words[0], *options), on=True)


def _switch(words: tuple[Located, ...], *, on: bool) -> Located | None:
    """The word of ``set`` or of a shell that switches the check on, or off."""
    short, sign = (_ON, "-") if on else (_OFF, "+")
    for before, word in pairwise(words):
        if short.fullmatch(word) or (word == "nounset" and before.startswith(sign)):
            return word
    return None


def _check(commands: Iterable[Command], strict: Located | None, effect: str) -> Iterator[Finding]:
    for command in commands:
        if command.name == "set":
            strict = _switch(command.words, on=True) or (None if _switch(command.words, on=False) else strict)
        if any(TRACE.match(word) for word in (*command.words, *command.assignments)):
            return
        sources = command.name in ("source", ".") and len(command.words) > 1 and SETUP.search(command.words[1])
        if strict is not None and sources:
            yield finding(
                command.words[1],
                f"The setup file reads unset variables: with 'set -u' {effect}",
                advice="source it before 'set -u', or between 'set +u' and 'set -u'",
                related=[note(strict, "unset variables become errors here")],
            )
