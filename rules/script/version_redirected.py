"""The shell takes the version in a command of pip for a redirection.

## What it finds
`pip install name>=1.2` and `pip install name<2` without quotes, in scripts and in steps of images that a shell runs:
`>` writes the output of pip to a file with the name `=1.2` (a warning), and `<` reads from a file `2`. The same for
apt, conda and mamba.

## Why it matters on a robot
With `>` pip installs the newest version, whatever the bound is for, and its messages go to a file `=1.2`.
With `<` there is no file `2`: the shell does not even start pip, and the library is missing.

## Bad
```sh
pip3 install numpy<2 pyserial>=3.5
```

## Good
```sh
pip3 install 'numpy<2' 'pyserial>=3.5'
```

## When to ignore it
Never.

## References
- bash(1), "REDIRECTION"
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Located
from bringup_lint.api import Related
from bringup_lint.api import Robot
from bringup_lint.api import Source
from bringup_lint.api import finding
from bringup_lint.api import note
from bringup_lint.api import regex
from bringup_lint.api import rule
from bringup_lint.api.docker import commands_of
from bringup_lint.api.shell import Command
from bringup_lint.api.shell import Redirect

PROGRAMS = ("pip", "pip3", "python", "python3", "uv", "apt", "apt-get", "conda", "mamba", "sudo")
VERSION = regex(r"=?\d+(?:\.(?:\d+|\*))*(?:[,<>=!][^\s]*)?")


@rule("error", symptoms=["cannot open 2: No such file"])
def version_redirected(robot: Robot) -> Iterator[Finding]:
    commands = [run.command for _, run in robot.scripts.run(*PROGRAMS)]
    for file in robot.dockerfiles:
        commands += [command for stage in file.stages for command in commands_of(stage) if command.name in PROGRAMS]
    found: dict[Source, list[tuple[Located, Redirect]]] = {}
    for command in commands:
        for name, redirect in _versions(command):
            found.setdefault(name.span.source, []).append((name, redirect))
    for redirected in found.values():
        first, *others = sorted(redirected, key=lambda each: each[1].operator == ">")
        yield _finding(*first, [note(redirect.target, f"{name}, too") for name, redirect in others if redirect.target])


def _versions(command: Command) -> Iterator[tuple[Located, Redirect]]:
    """The redirections that are glued to the name of a package."""
    if "install" not in command.words:
        return
    names = {word.span.end: word for word in command.words[1:] if not word.startswith("-")}
    for each in command.redirects:
        if each.target is not None and each.operator in ("<", ">") and VERSION.fullmatch(each.target):
            name = names.get(each.target.span.start - len(each.operator))
            if name is not None:
                yield name, each


def _finding(name: Located, redirect: Redirect, related: list[Related]) -> Finding:
    text = f"{name}{redirect.operator}{redirect.target}"
    severity = None
    if redirect.operator == "<":
        what = f"the shell reads from a file '{redirect.target}', and the command does not start without it"
    else:
        severity = "warning"
        what = f"the shell writes to a file '{redirect.target}', and any version of {name} is installed"
    return finding(
        redirect.target or name,
        f"{text} is a redirection: {what}",
        advice=f"write '{text}' in quotes",
        severity=severity,
        related=related,
    )
