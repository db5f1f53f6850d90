"""A script ends with success, whatever failed in it.

## What it finds
A script without `set -e` in which two or more steps bring something - `apt-get install`, `pip install`,
`rosdep install`, `vcs import`, `git clone`, `wget`, `curl`, `dpkg -i`, `make`, `colcon build` - and nobody looks at
their results, and that ends with `echo`, `printf`, `rm`, `reboot` or `systemctl daemon-reload`.

Also, with `set -e` too, an installation that fails with nothing but a message (`apt-get install ... || echo "failed"`)
before the script enables or starts a unit, whatever came of it.

Steps before a question of another command with `exit` (`dpkg -s chrony || exit 1`) are not counted. Silent if the
script asks for `$?` or has a trap for ERR, if another one sources it, and where all the steps are builds
with colcon, which script/build-unchecked judges.

## Why it matters on a robot
A download that breaks off, or a package that is not found, does not end the installation. The last command succeeds,
so whoever runs the script - a person, the build of an image, a unit - takes the robot for complete, and a driver is
missing when it is started.

## Bad
```sh
#!/bin/bash
sudo apt-get install -y can-utils
wget -q -O /tmp/arm.deb https://example.org/arm.deb
sudo dpkg -i /tmp/arm.deb
rm /tmp/arm.deb
```

## Good
```sh
#!/bin/bash
set -e
sudo apt-get install -y can-utils
wget -q -O /tmp/arm.deb https://example.org/arm.deb
sudo dpkg -i /tmp/arm.deb
rm /tmp/arm.deb
```

## When to ignore it
When the robot works without what the script installs.

## References
- bash(1), "set": errexit
- bash(1), "exit"
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
from bringup_lint.api.shell import STRICT
from bringup_lint.api.shell import Run

LOOKS = regex(STRICT + r"|\btrap [^\n]{0,200}\bERR\b|\$\?|\$\{\?\}|\bPIPESTATUS\b", re.M)
CONDITION = regex(r"\b(?:if|elif|while|until)\b[^;\n]{0,200}$|![ \t]*$")
BRINGS = {
    "apt": ("install",),
    "apt-get": ("install",),
    "colcon": ("build",),
    "curl": (),
    "dpkg": ("-i", "--install"),
    "git": ("clone",),
    "make": (),
    "pip": ("install",),
    "pip3": ("install",),
    "rosdep": ("install",),
    "vcs": ("import",),
    "wget": (),
}
"""Program -> its commands that bring something; empty: it does nothing else."""
SUCCEED = ("echo", "printf", "rm", "reboot")
CLEANS = frozenset({"clean", "distclean", "mrproper", "uninstall"})
"""Targets of make that bring nothing."""
LINKED = regex(r"&&|\|\|")
STARTS = frozenset({"enable", "start", "restart"})
PRINTS = ("echo", "printf")
INSTALLERS = ("apt", "apt-get", "dpkg", "pip", "pip3")
FAILED = regex(r"\b(?:[Ff]ailed|FAILED|[Ff]ailure|[Ee]rror|ERROR|[Cc]ould not|[Cc]annot|[Uu]nable to)\b")
UNNEEDED = regex(r"\b(?:skip\w*|already|optional\w*|ignor\w*|continu\w*)\b", re.I)
LEAST = 2
"""Steps; who ignores only one may mean it."""


@rule("warning", confidence="medium", silent="the script ends with success")
def failure_unseen(robot: Robot) -> Iterator[Finding]:
    for source in robot.of_kind("shell-script"):
        if not source.judged or robot.purpose(source).value != "robot":
            continue
        if "||" in source.said and "systemctl" in source.said:
            yield from _only_told(robot, source)
        if LOOKS.search(source.text):
            continue
        runs = [did for did in robot.scripts.done(source) if isinstance(did, Run) and did.words]
        ignored = [run for run in _not_looked_at(runs) if _is_ignored(run)]
        if len(ignored) < LEAST or all(run.name == "colcon" for run in ignored):
            continue
        last = runs[-1]
        is_told = last.certain and _succeeds(last) and not last.command.depth and not _is_linked(last, runs)
        if is_told and not _is_sourced(robot, source):
            yield finding(
                ignored[0].words[0],
                f"When this fails, the script goes on and ends with the success of '{last.name}'",
                advice="begin the script with set -e",
                related=[
                    note(_first_line(source), "nothing here makes a failure end the script"),
                    *(note(run.words[0], "a failure is ignored here too") for run in ignored[1:20]),
                    note(last.words[0], "this succeeds in any case"),
                ],
            )


def _succeeds(run: Run) -> bool:
    """Whether a command says nothing of those before it."""
    return run.name in SUCCEED or (run.name == "systemctl" and "daemon-reload" in run.arguments)


def _is_linked(last: Run, runs: list[Run]) -> bool:
    """Whether the last command runs, or not, by the result of the one before it."""
    span = last.words[0].span
    is_next = any(run.command.ends in ("&&", "||") for run in runs[-2:-1])
    return is_next or LINKED.search(span.source.line_before(span.start)) is not None


def _not_looked_at(runs: list[Run]) -> list[Run]:
    """The commands after the last question that ends the script, other than for the result of a step itself."""
    asked = [at for at, run in enumerate(runs) if at and run.name == "exit" and runs[at - 1].name not in BRINGS]
    return runs[asked[-1] :] if asked else runs


def _only_told(robot: Robot, source: Source) -> Iterator[Finding]:
    """The first installation whose failure is only told, though a unit is enabled or started afterwards."""
    runs = [did for did in robot.scripts.done(source) if isinstance(did, Run) and did.words]
    started: Run | None = None
    told: list[Run] = []
    hidden: tuple[Run, Run, Run] | None = None
    for run in reversed(runs):
        if not run.certain:
            told.append(run)
            continue
        if started is not None and _installs(run) and _is_message(told):
            hidden = run, told[-1], started
        if run.name == "systemctl" and not run.command.depth and STARTS & {*run.arguments}:
            started = run
        told = []
    if hidden is not None:
        install, message, unit = hidden
        yield finding(
            install.words[0],
            "When this fails, the script only says so, and starts the unit without what it has to install",
            advice="write exit 1 after the message",
            related=[note(message.words[0], "the message"), note(unit.words[0], "this runs all the same")],
        )


def _is_message(told: list[Run]) -> bool:
    """Whether the commands after ``||`` only say that something failed."""
    said = " ".join(" ".join(each.words) for each in reversed(told))
    return {each.name for each in told} <= {*PRINTS} and bool(FAILED.search(said)) and not UNNEEDED.search(said)


def _installs(run: Run) -> bool:
    if run.command.ends != "||" or run.command.depth or run.name not in INSTALLERS:
        return False
    return any(word in BRINGS[run.name] for word in run.arguments)


def _is_sourced(robot: Robot, source: Source) -> bool:
    """Whether a file of the tree reads the script into its own shell, for which `set -e` would count, too."""
    reads = re.compile(rf"(?:^|[\s;&(])(?:source|\.)[ \t]+[^\s;&|]{{0,200}}{re.escape(source.basename)}\b", re.M)
    return any(source.basename in each.text and reads.search(each.text) for each in robot.sources)


def _first_line(source: Source) -> Span:
    return source.span(0, max(source.text.find("\n"), 1))


def _is_ignored(run: Run) -> bool:
    if not run.certain or run.name not in BRINGS or run.command.depth or run.command.ends in ("&&", "||", "|", "&"):
        return False
    targets = [word for word in run.arguments if not word.startswith("-")]
    if run.name == "make" and targets and CLEANS.issuperset(targets):
        return False
    asks = BRINGS[run.name]
    if asks and not any(word in asks for word in run.arguments):
        return False
    span = run.command.words[0].span
    return CONDITION.search(span.source.line_before(span.start)) is None
