"""systemd expands ${...} before the shell of the Exec line sees it.

## What it finds
In the text of `bash -c '...'`: ${X} where the same text sets X, and forms that only a shell knows, such as
${X%.*}, ${X[0]} and ${1}.

These are exempt: variables that the unit or its environment files set, ${X:-default} and $X inside a longer
text (which systemd does not expand), and lines with the prefix `:` (which turns expansion off).

## Why it matters on a robot
systemd looks up the name in the environment of the service, does not find it and substitutes nothing. The
shell then runs a command with a gap in it, such as rm -rf /tmp/ or a launch without its argument.

## Bad
```ini
[Service]
ExecStart=/bin/bash -c 'D=/var/log/robot; mkdir -p ${D} && exec robot-drivers --log ${D}'
```

## Good
```ini
[Service]
ExecStart=/bin/bash -c 'D=/var/log/robot; mkdir -p $${D} && exec robot-drivers --log $${D}'
```

## When to ignore it
When the variable reaches the service manager another way, and its value is the one that the shell should see.

## References
- systemd.service(5), "Command lines": $$ is a literal dollar
- journal: "Referenced but unset environment variable evaluates to an empty string: D"
"""

import re
from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Located
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import fix
from bringup_lint.api import regex
from bringup_lint.api import rule
from bringup_lint.api.systemd import Command
from bringup_lint.api.systemd import Line

_USE = regex(r"(?<!\$)(?:\$\$)*\$\{([^}:]*)\}")
_NAME = regex(r"[A-Za-z_][A-Za-z0-9_]*")
_SET = (
    r"(?:^|[\s;&|({{])(?:(?:export|local|readonly|declare|typeset)\s+(?:-\w+\s+)*)?{0}\+?="
    r"|\bfor\s+{0}\b|\bread\s[^;|&]*\b{0}\b"
)
_SHELLS = ("sh", "bash", "dash", "zsh", "ksh")


@rule(
    "warning",
    fix="unsafe",
    symptoms=["Referenced but unset environment variable evaluates to an empty string"],
)
def shell_var_swallowed(robot: Robot) -> Iterator[Finding]:
    for line in robot.units.lines:
        for command in line.commands:
            text = _shell_text(command) if command.expands_variables else None
            if text is not None and "${" in text:
                yield from _swallowed(robot, line, text)


def _shell_text(command: Command) -> Located | None:
    """The text after ``sh -c``."""
    names = [word.rpartition("/")[2] for word in command.argv]
    shell = next((at for at, name in enumerate(names) if name in _SHELLS), None)
    if shell is None:
        return None
    for at in range(shell + 1, len(names) - 1):
        if names[at].startswith("-") and not names[at].startswith("--") and "c" in names[at]:
            return command.argv[at + 1]
    return None


def _swallowed(robot: Robot, line: Line, text: Located) -> Iterator[Finding]:
    for found in _USE.finditer(text):
        name = found[1]
        start = found.end() - len(name) - 3
        plain = _NAME.fullmatch(name) is not None
        if plain and (not re.search(_SET.format(re.escape(name)), text) or _provided(robot, line, name)):
            continue
        use = text.part(start, found.end())
        what = f"and {name} is set only in this shell text" if plain else "which only a shell understands"
        yield finding(
            use,
            f"systemd replaces {use} with nothing before the shell sees it, {what}",
            advice=f"write ${use}",
            fix=fix("double the dollar", (text.part(start, start + 1), "$$"), safe=False),
        )


def _provided(robot: Robot, line: Line, name: str) -> bool:
    """Whether systemd may know the variable: the unit, an environment file or systemd itself may set it."""
    for assignment in line.file.assignments:
        if assignment.key in ("Environment", "PassEnvironment") and name in assignment.value:
            return True
        if assignment.key == "EnvironmentFile":
            source = robot.tree.find(assignment.value.lstrip("-"))
            if source is None or re.search(rf"\b{re.escape(name)}\b", source.text):
                return True
    return name in ("HOME", "USER", "LOGNAME", "SHELL", "PATH", "LANG", "TERM", "MAINPID")
