"""A search path is read under `set -u` before anything sets it.

## What it finds
`$LD_LIBRARY_PATH`, `$PYTHONPATH` and the like, without a default, in a bash or sh script after `set -u`, where the
script has neither set the variable nor sourced a file before. Only scripts that a system unit starts without another
shell, and whose environment surely does not hold the variable.

## Why it matters on a robot
In the shell of a developer, ROS has set the variable. A service starts with an empty environment: the script exits with
"unbound variable", and the robot's software does not start.

## Bad
```sh
set -euo pipefail
export LD_LIBRARY_PATH=/opt/vendor/lib:$LD_LIBRARY_PATH
```

## Good
```sh
set -euo pipefail
export LD_LIBRARY_PATH=/opt/vendor/lib:${LD_LIBRARY_PATH:-}
```

## When to ignore it
When an image that is not in the tree sets the variable.

## References
- bash(1), "set -u" and "Parameter Expansion"
"""

import re
from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import Source
from bringup_lint.api import Span
from bringup_lint.api import finding
from bringup_lint.api import note
from bringup_lint.api import regex
from bringup_lint.api import rule
from bringup_lint.api.shell import Command
from bringup_lint.api.shell import shell_commands
from bringup_lint.api.systemd import Unit

NAMES = ("LD_LIBRARY_PATH", "PYTHONPATH", "AMENT_PREFIX_PATH", "CMAKE_PREFIX_PATH", "ROS_PACKAGE_PATH", "DISPLAY")
USE = regex(rf"(?<![\\'\w])\$(?:(?P<plain>{'|'.join(NAMES)})(?!\w)|\{{(?P<braced>{'|'.join(NAMES)})\}})")
ON = regex(r"-[a-zA-Z]*u[a-zA-Z]*|nounset")
OFF = regex(r"\+[a-zA-Z]*u[a-zA-Z]*")
GIVES = regex(r"\$\{(?P<name>\w+):?[=?]")
DECLARES = ("export", "declare", "local", "readonly", "typeset", "read", "unset")


@rule("error", confidence="medium", symptoms=["LD_LIBRARY_PATH: unbound variable", "PYTHONPATH: parameter not set"])
def unset_variable(robot: Robot) -> Iterator[Finding]:
    started: dict[str, list[Unit]] | None = None
    for source in robot.of_kind("shell-script"):
        if not source.judged or source.template or not any(name in source.text for name in NAMES):
            continue
        found = _first_use(source)
        if found is None:
            continue
        use, name, strict = found
        if started is None:
            started = _started(robot)
        if _starts_without(robot, source, name, started.get(source.basename, [])):
            yield finding(
                use,
                f"{name} is not set when this script starts: with 'set -u' it exits here",
                advice=f"write ${{{name}:-}}",
                related=[note(strict, "unset variables become errors here")],
            )


def _first_use(source: Source) -> tuple[Span, str, Span] | None:
    """The first variable that is surely not set, with the command that makes this an error."""
    strict: Span | None = None
    known: set[str] = set()
    before = ""
    for command in shell_commands(source):
        words = command.words
        judged = strict is not None and not command.depth and before not in ("&&", "||")
        before = command.ends
        if command.name == "set":
            strict = _after_set(command, strict)
        elif command.name in ("source", ".", "eval"):
            return None
        for word in (*command.assignments, *words):
            use = USE.search(word) if "'" not in word.span.text else None
            name = (use["plain"] or use["braced"]) if use else ""
            if (
                use
                and strict
                and judged
                and name not in known
                and f"${{{name}:" not in word
                and f"${{{name}+" not in word
            ):
                return word.part(*use.span()).span, name, strict
        names = (*command.assignments, *(words[1:] if command.name in DECLARES else ()))
        known.update(re.split(r"\+?=", word)[0] for word in names)
        known.update(match["name"] for word in words for match in GIVES.finditer(word))
    return None


def _after_set(command: Command, strict: Span | None) -> Span | None:
    words = command.words[1:]
    if any(map(OFF.fullmatch, words)) or ("+o" in words and "nounset" in words):
        return None
    return command.words[0].span if any(map(ON.fullmatch, words)) else strict


def _started(robot: Robot) -> dict[str, list[Unit]]:
    """The last part of each of the first words of a command -> the services that may start a file of that name."""
    found: dict[str, list[Unit]] = {}
    for unit in robot.units.services:
        lines = (process.line for process in robot.units.processes(unit))
        for name in {word.rpartition("/")[2] for line in lines for word in line.split(None, 2)[:2]}:
            found.setdefault(name, []).append(unit)
    return found


def _starts_without(robot: Robot, source: Source, name: str, units: list[Unit]) -> bool:
    """Whether only system units start the script, as the first program, and one of them has no such variable."""
    own = re.escape(source.basename)
    if robot.scripts.is_for_image(source):
        return False
    direct = re.compile(rf"(?:\S*/(?:ba|da)?sh[ \t]+)?/\S*/{own}(?:[ \t].*)?")
    return any(
        unit.manager == "system"
        and not unit.has("PassEnvironment")
        and robot.units.environment(unit).defines(name) is False
        and any(direct.fullmatch(process.line) for process in robot.units.processes(unit))
        for unit in units
    )
