"""The shell takes the version in a command of pip for a redirection.

## What it finds
`pip install name>=1.2` and `pip install name<2` without quotes, in scripts and in steps of images that a shell runs:
`>` writes the output of pip to a file with the name `=1.2` (a warning; info where `-U` takes the newest version
anyway and there is no upper bound), and `<` reads from a file `2`. The same for
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
from bringup_lint.api import NamedTuple
from bringup_lint.api import Related
from bringup_lint.api import Robot
from bringup_lint.api import Source
from bringup_lint.api import finding
from bringup_lint.api import note
from bringup_lint.api import regex
from bringup_lint.api import rule
from bringup_lint.api.docker import commands_of
from bringup_lint.api.shell import Command

PROGRAMS = ("pip", "pip3", "python", "python3", "uv", "apt", "apt-get", "conda", "mamba", "sudo")
UPGRADES = ("-U", "--upgrade")
SEVERITIES = ("error", "warning", "info")
VERSION = regex(r"=?\d+(?:\.(?:\d+|\*))*(?:[,<>=!][^\s]*)?")


class Redirected(NamedTuple):
    """A version that the shell takes for a file."""

    name: Located
    operator: str
    version: Located
    newest: bool
    """The command takes the newest version."""

    @property
    def severity(self) -> str:
        """What is lost: the command, the bound, or nothing."""
        if self.operator == "<":
            return "error"
        return "info" if self.newest and "<" not in self.version else "warning"


@rule("error", symptoms=["cannot open 2: No such file"])
def version_redirected(robot: Robot) -> Iterator[Finding]:
    commands = [run.command for _, run in robot.scripts.run(*PROGRAMS)]
    for file in robot.dockerfiles:
        commands += [command for stage in file.stages for command in commands_of(stage) if command.name in PROGRAMS]
    found: dict[Source, list[Redirected]] = {}
    for command in commands:
        for each in _redirected(command):
            found.setdefault(each.name.span.source, []).append(each)
    for redirected in found.values():
        first, *others = sorted(redirected, key=lambda each: SEVERITIES.index(each.severity))
        yield _finding(first, [note(each.version, f"{each.name}, too") for each in others])


def _redirected(command: Command) -> Iterator[Redirected]:
    """The redirections that are glued to the name of a package."""
    if "install" not in command.words:
        return
    newest = any(word in UPGRADES for word in command.words)
    names = {word.span.end: word for word in command.words[1:] if not word.startswith("-")}
    for each in command.redirects:
        if each.target is not None and each.operator in ("<", ">") and VERSION.fullmatch(each.target):
            name = names.get(each.target.span.start - len(each.operator))
            if name is not None:
                yield Redirected(name, each.operator, each.target, newest)


def _finding(redirected: Redirected, related: list[Related]) -> Finding:
    name, operator, version, _ = redirected
    text = f"{name}{operator}{version}"
    if operator == "<":
        what = f"the shell reads from a file '{version}', and the command does not start without it"
    else:
        which = "the newest" if redirected.newest else "any"
        what = f"the shell writes to a file '{version}', and {which} version of {name} is installed"
    return finding(
        version,
        f"{text} is a redirection: {what}",
        advice=f"write '{text}' in quotes",
        severity=redirected.severity,
        related=related,
    )
