"""DEBIAN_FRONTEND does not reach apt.

## What it finds
A script that sets `DEBIAN_FRONTEND`, and calls of apt that do not see it: without `export` it stays in the shell, and
`sudo` hands no variable on unless it is called with `-E`, or has the variable behind it. Silent where the script sets
the variable behind `sudo` elsewhere, presets answers for debconf, or something of the tree lets sudo keep it, and for
scripts that a file calls which sets the variable itself.

## Why it matters on a robot
The packages that ask (keyboard, time zone, iptables-persistent, a changed file in `/etc`) open their dialog all the
same. Nobody answers it in a set-up over SSH or at the first boot: the installation waits without end, or ends with an
error of debconf.

## Bad
```sh
export DEBIAN_FRONTEND=noninteractive
sudo apt-get install -y iptables-persistent
```

## Good
```sh
sudo DEBIAN_FRONTEND=noninteractive apt-get install -y iptables-persistent
```

## When to ignore it
When sudo is set up to keep the variable (`env_keep`), or whoever calls the script has exported it.

## References
- debconf(7), "DEBIAN_FRONTEND"
- sudoers(5), "Command environment"
- bash(1), "ENVIRONMENT"
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Located
from bringup_lint.api import Robot
from bringup_lint.api import Source
from bringup_lint.api import finding
from bringup_lint.api import note
from bringup_lint.api import regex
from bringup_lint.api import rule
from bringup_lint.api.shell import Run
from bringup_lint.api.shell import shell_commands

NAME = "DEBIAN_FRONTEND"
SET = regex(r"DEBIAN_FRONTEND=[\"']?noninteractive[\"']?")
HANDED_ON = regex(
    r"\b(?:export|declare[ \t]+-x|typeset[ \t]+-x)\b[^\n;#]{0,80}DEBIAN_FRONTEND|\bset[ \t]+-(?:a|o[ \t]+allexport)"
)
OTHERWISE = regex(r"debconf|sudo[ \t][^\n]{0,60}DEBIAN_FRONTEND|env_keep|--preserve-env|sudo[ \t]+-[A-Za-z]*E")
KEEPS = regex(r"env_keep[^\n]{0,80}DEBIAN_FRONTEND", hints="env_keep")
PROGRAMS = ("apt", "apt-get")
ASKING = ("install", "upgrade", "dist-upgrade", "full-upgrade")


@rule("warning", symptoms=["debconf: unable to initialize frontend: Dialog"])
def frontend_lost(robot: Robot) -> Iterator[Finding]:
    places = {source: place for source in robot.of_kind("shell-script") if (place := _set_in(source)) is not None}
    if not places or robot.mentions(KEEPS):
        return
    lost: dict[Source, list[Run]] = {}
    seen: dict[Source, list[Run]] = {}
    for source, run in robot.scripts.run(*PROGRAMS):
        if source in places and any(word in ASKING for word in run.words[1:]):
            is_lost = run.by_root or not source.says(HANDED_ON)
            (lost if is_lost and not _has_own(run) else seen).setdefault(source, []).append(run)
    setting = [each for each in robot.sources if NAME in each.text] if lost else []
    for source, (first, *others) in lost.items():
        if source in seen or any(source.basename in each.text for each in setting if each is not source):
            continue
        why = "sudo does not hand it on" if source.says(HANDED_ON) else "it is not exported"
        yield finding(
            first.words[0],
            f"apt does not see {NAME}: {why}, and a package that asks waits for an answer",
            advice=f"write sudo {NAME}=noninteractive apt-get ..." if first.by_root else f"write export {NAME}=...",
            related=[
                note(places[source], "set here, for the shell alone"),
                *(note(other.words[0], "nor does this call") for other in others[:8]),
            ],
        )


def _set_in(source: Source) -> Located | None:
    """The place where a script sets the variable for all that follows."""
    if NAME not in source.said or not source.judged or source.template or OTHERWISE.search(source.said):
        return None
    for command in shell_commands(source):
        words = command.words[1:] if command.name in ("export", "declare", "typeset") else ()
        for word in (*words, *(() if command.words else command.assignments)):
            if SET.fullmatch(word):
                return word
    return None


def _has_own(run: Run) -> bool:
    """Whether a call has the variable in front."""
    return not run.by_root and any(word.startswith(NAME) for word in (*run.command.assignments, *run.command.words))
