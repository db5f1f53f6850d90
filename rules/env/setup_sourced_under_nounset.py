"""A setup file is sourced with set -u.

## What it finds
`source .../setup.bash` in a script after `set -u`, `set -eu...` or `set -o nounset`, without a `set +u` in between.
Only setup files below `/opt/ros/`, `install/` and `devel/` count, because another `setup.sh` may be anything. Silent if
the script sets AMENT_TRACE_SETUP_FILES.

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
- ament_package, `prefix_level/setup.sh`: reads AMENT_TRACE_SETUP_FILES
"""

import re
from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import Source
from bringup_lint.api import finding
from bringup_lint.api import note
from bringup_lint.api import regex
from bringup_lint.api import rule
from bringup_lint.api.shell import shell_commands

SETUP = regex(r"(?:^|/)(?:opt/ros/[^/]+|install|install_\w+|devel)/(?:local_)?setup\.(?:bash|sh)$")
"""The files of a distribution or of a built workspace; another setup.sh may be anything."""

TRACE = regex(r"AMENT_TRACE_SETUP_FILES=|\$\{AMENT_TRACE_SETUP_FILES:?=")
"""What sets the variable that each setup file reads first."""


@rule(
    "error",
    symptoms=[
        "AMENT_TRACE_SETUP_FILES: unbound variable",
        "COLCON_TRACE: unbound variable",
        "setup.bash: line *: unbound variable",
    ],
)
def setup_sourced_under_nounset(robot: Robot) -> Iterator[Finding]:
    for source in robot.of_kind("shell-script"):
        if source.judged and not source.template and "setup." in source.said:
            yield from _check(source)


def _check(source: Source) -> Iterator[Finding]:
    strict = None
    for command in shell_commands(source):
        words = [str(word) for word in command.words]
        if words[:1] == ["set"]:
            if ("nounset" in words and "-o" in words) or any(
                re.fullmatch(r"-[a-zA-Z]*u[a-zA-Z]*", word) for word in words[1:]
            ):
                strict = command.words[0]
            elif ("nounset" in words and "+o" in words) or any(
                re.fullmatch(r"\+[a-zA-Z]*u[a-zA-Z]*", word) for word in words[1:]
            ):
                strict = None
        if any(TRACE.match(word) for word in (*words, *command.assignments)):
            return
        sources = words[:1] in (["source"], ["."]) and len(words) > 1 and SETUP.search(words[1]) is not None
        if strict is not None and sources:
            yield finding(
                command.words[1],
                "The setup file reads unset variables: with 'set -u' the script exits here",
                advice="source it before 'set -u', or between 'set +u' and 'set -u'",
                related=[note(strict, "unset variables become errors here")],
            )
