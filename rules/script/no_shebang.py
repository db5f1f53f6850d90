"""A script that is started by its path does not say which interpreter it is for.

## What it finds
A text file of the tree that a unit starts directly and whose first line does not begin with `#!`: no such line at all,
or a misspelt one such as `#/bin/sh`. A misspelt one is a warning in every other script but the completions of shells,
which are never started. A folder that no system has, such as `/usr/env/bin`, is an error. One behind blanks or empty
lines is a warning where something of the tree starts the script, and else an info: from a shell it starts.

## Why it matters on a robot
The kernel executes a text file only by its first line. systemd has no shell to fall back to: the unit fails with
"Exec format error" (203/EXEC) at every start. In a terminal the same script works, because the shell then reads it by
itself.

## Bad
```sh
#/bin/sh
exec ros2 launch rover rover.launch.py
```

## Good
```sh
#!/bin/sh
exec ros2 launch rover rover.launch.py
```

## When to ignore it
When binfmt_misc knows the file.

## References
- execve(2), ENOEXEC
- systemd.exec(5), "Process Exit Codes": 203/EXEC
"""

import re
from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import note
from bringup_lint.api import regex
from bringup_lint.api import rule

SCRIPT = regex(r"\.(?:sh|bash|py|pl|zsh)$")
COMPILED = "\0"
MISSPELT = regex(
    r"(?:[ \t]*\n)?((?:#|!# ?|# ! ?)/(?:usr/)?bin/(?:env +)?(?:ba|da|z)?sh(?: -\w+)?)[ \t\r]*$",
    re.M,
)
"""A first line with such a mistake."""
WRONG = regex(r"#![ \t]*(/(?:usr/env/bin|user/bin|usr/bin/bin|bin/usr|usr/(?:ba|da|z)?sh|usr/env)(?![\w.-])\S{0,100})")
"""An interpreter in a folder that no system has."""
INDENTED = regex(r"[ \t\r\n]+(#![ \t]*/[^\n]*)")


@rule(
    "error",
    symptoms=[
        "Exec format error",
        "203/EXEC",
        "Failed to execute *: Exec format error",
        "Failed at step EXEC spawning *: Exec format error",
    ],
)
def no_shebang(robot: Robot) -> Iterator[Finding]:
    seen = set()
    for unit in robot.units.services:
        for process in robot.units.processes(unit):
            program = process.program
            source = robot.find(str(program), program.span.source) if program.startswith("/") else None
            if source is None or source in seen or source.template or not SCRIPT.search(source.name):
                continue
            if source.text.startswith("#!") or COMPILED in source.text or not source.text.strip():
                continue
            seen.add(source)
            first = source.located(0, max(source.text.find("\n"), 1))
            yield finding(
                first,
                f"The first line names no interpreter: {unit.name} fails with 'Exec format error'",
                advice="begin the file with #!/bin/bash, or whatever reads it",
                related=[note(program, f"{unit.name} starts it")],
            )
    for source in robot.of_kind("shell-script"):
        wrong = WRONG.match(source.text) if source.judged and not source.template else None
        if wrong is not None:
            path = source.located(*wrong.span(1))
            yield finding(
                path,
                f"No system has {path}: the kernel cannot start the script",
                advice="write #!/usr/bin/env bash, or the path of the interpreter",
            )
        if not source.judged or source in seen or source.text.startswith("#!"):
            continue
        indented = INDENTED.match(source.said) if not source.template else None
        misspelt = MISSPELT.match(source.said)
        if indented is not None:
            yield finding(
                source.located(*indented.span(1)),
                "The file begins with blanks and so names no interpreter: only a shell can start the script",
                advice="remove the blanks",
                severity="warning" if robot.scripts.starts_by_itself(source) else "info",
            )
        elif misspelt is not None and "complet" not in source.basename:
            yield finding(
                source.located(*misspelt.span(1)),
                "The first line is a comment and names no interpreter: only a shell can start the script",
                advice="write #! in front of the path",
                severity="warning",
            )
