"""pkill -f ends the script that runs it.

## What it finds
`pkill -f PATTERN` in a script whose own name the pattern matches, and in the text after `sh -c` of a unit, container or
cron job, where other commands follow or precede it. In a script it is an info if only messages or `exit` follow. Only
patterns without special characters are compared. A pattern such as `[r]os2`, which does not match itself, is fine.

## Why it matters on a robot
`pkill -f` compares the pattern with whole command lines. That of the shell, `bash ./ros2_cleanup.sh`, matches as well:
the shell gets the signal, and what comes after it never runs.

## Bad
```sh
# ros2_cleanup.sh
pkill -9 -f ros2
ros2 daemon start
```

## Good
```sh
# ros2_cleanup.sh
pkill -9 -f '/opt/ros/[^ ]*/bin/ros2 launch'
ros2 daemon start
```

## When to ignore it
When the script is run under another name.

## References
- pgrep(1), "-f" and "NOTES": pgrep and pkill only leave themselves out
"""

import re
from collections.abc import Iterator
from typing import Literal

from bringup_lint.api import Finding
from bringup_lint.api import Located
from bringup_lint.api import Robot
from bringup_lint.api import Source
from bringup_lint.api import finding
from bringup_lint.api import regex
from bringup_lint.api import rule
from bringup_lint.api.shell import Run
from bringup_lint.api.shell import unwrapped

VALUED = ("-u", "-U", "-g", "-G", "-P", "-s", "-t", "--signal", "--euid", "--uid")
QUIET = ("echo", "printf", "exit", "true", "")
LITERAL = regex(r"[\w ./:@=+-]+")


@rule("warning", symptoms=["Terminated", "exited with code 143", "exited with code 137"])
def pkill_self(robot: Robot) -> Iterator[Finding]:
    for source, run in robot.scripts.run("pkill"):
        pattern = _pattern(run.words)
        if pattern is not None and _matches(run.text(pattern), source.basename):
            yield _finding(pattern, source.basename, "warning" if _goes_on(robot, source, run) else "info")
    for runner in robot.runners.all:
        for line in runner.lines:
            own = [step.command for step in line.steps if step.depth == 1 and step.script is None]
            if len(own) < 2 or not line.argv or not line.shell:
                continue
            for command in own:
                pattern = _pattern(unwrapped(command.words))
                if pattern is not None and command.name == "pkill" and _matches(str(pattern), str(line.line)):
                    yield _finding(pattern, f"the shell of {runner.name}", "warning")


def _goes_on(robot: Robot, source: Source, pkill: Run) -> bool:
    """Whether the script does anything after the command, which it does not live to see."""
    runs = [did for did in robot.scripts.done(source) if isinstance(did, Run) and did.words]
    after = (run for run in runs if run.words[0].span.start > pkill.words[0].span.start)
    return any(run.name not in QUIET for run in after)


def _pattern(words: tuple[Located, ...]) -> Located | None:
    """What pkill compares with whole command lines; None without -f."""
    if not any(re.fullmatch(r"-[a-zA-Z]*f[a-zA-Z]*|--full", word) for word in words[1:]):
        return None
    plain = [word for at, word in enumerate(words) if at and not word.startswith("-") and words[at - 1] not in VALUED]
    return plain[-1] if plain else None


def _matches(pattern: str, text: str) -> bool:
    return bool(LITERAL.fullmatch(pattern)) and re.search(pattern, text) is not None


def _finding(pattern: Located, name: str, severity: Literal["warning", "info"]) -> Finding:
    return finding(
        pattern,
        f"The pattern matches the command line of {name} as well: it gets the signal itself",
        severity=severity,
        advice="write a pattern that only the program matches, or put its first letter in brackets: '[r]os2'",
    )
