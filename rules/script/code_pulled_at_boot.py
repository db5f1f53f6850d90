"""The robot takes the newest commit of a branch at every boot.

## What it finds
`git pull` that always runs before the robot's software: in what a service that starts at boot, a compose service, an
`@reboot` line of cron or a program of supervisord runs, and in scripts whose names say that they are for the boot
(`boot.sh`, `autostart.sh`, `rc.local`). Silent for pulls under a condition, and for what does nothing but update.

## Why it matters on a robot
Whatever was pushed last, tested or not, is what the robot runs after it was switched on, and two robots run different
versions. Where the network is slow or missing, git waits for it or fails at every start.

## Bad
```sh
cd /opt/rover && git pull origin main
python3 drive.py
```

## Good
```sh
# deploy.sh, run by a person: git fetch --tags && git checkout v1.4.2
cd /opt/rover
python3 drive.py
```

## When to ignore it
When the branch holds only what was tested on a robot.

## References
- git-pull(1)
- CWE-494: Download of Code Without Integrity Check
"""

from collections.abc import Iterable
from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Located
from bringup_lint.api import Robot
from bringup_lint.api import Source
from bringup_lint.api import finding
from bringup_lint.api import regex
from bringup_lint.api import rule
from bringup_lint.api.compose import is_workplace
from bringup_lint.api.docker import Runner
from bringup_lint.api.shell import Command
from bringup_lint.api.shell import program_name
from bringup_lint.api.shell import shell_commands
from bringup_lint.api.shell import unwrapped

BOOT = frozenset(("boot", "autostart", "startup", "bootup", "onboot"))
"""Words in the names of scripts that something outside of the tree starts at boot."""
PULL = regex(r"\bgit\b[^\n]{0,80}\bpull\b", hints="git")
UPDATES = regex(r"updat|upgrad|deploy|install|sync|pull|fetch|build|publish")
BESIDE = frozenset(
    "git cd echo printf exit sleep set source . export colcon make cmake catkin_make pip pip3 apt apt-get rosdep vcs "
    "chmod chown mkdir cp rm mv true test [ [[ logger date ping nmcli trap wait tee".split()
)
"""Programs of an update, or beside it."""


@rule(
    "warning", tags=["CWE-494"], symptoms=["fatal: unable to access *: Could not resolve host", "Already up to date."]
)
def code_pulled_at_boot(robot: Robot) -> Iterator[Finding]:
    if not robot.mentions(PULL):
        return
    seen = set()
    for name, commands in _started_at_boot(robot):
        pull = _pull(commands)
        if pull is not None and pull.span not in seen:
            seen.add(pull.span)
            yield finding(
                pull,
                f"At every start, {name} pulls whatever was pushed last, tested or not, and runs it",
                advice="remove the pull, and update to a tested tag by hand or with a tool for it",
            )


def _started_at_boot(robot: Robot) -> Iterator[tuple[str, Iterable[Command]]]:
    """What starts with the robot, each with its commands."""
    for runner in robot.runners.all:
        if not UPDATES.search(runner.name) and _is_for_boot(robot, runner):
            for line in runner.lines:
                yield runner.name, [step.command for step in line.steps]
    for source in robot.of_kind("shell-script"):
        if source.judged and not source.template and _is_named_for_boot(source):
            yield source.basename, shell_commands(source)


def _is_named_for_boot(source: Source) -> bool:
    words = source.basename.replace("-", "_").partition(".")[0].split("_")
    return source.basename == "rc.local" or not BOOT.isdisjoint(words)


def _is_for_boot(robot: Robot, runner: Runner) -> bool:
    if runner.unit is not None:
        return any(robot.units.wanted_by(runner.unit))
    if runner.service is not None:
        return not is_workplace(robot.compose, runner.service)
    return runner.kind.name in ("CRON", "PROGRAM")


def _pull(commands: Iterable[Command]) -> Located | None:
    """The first pull that always runs, where something of the robot starts after it."""
    found: Located | None = None
    for command in commands:
        words = unwrapped(command.words)
        name = program_name(words[0]) if words else ""
        if found is None and name == "git" and not command.depth:
            found = next((word for word in words[1:] if word == "pull"), None)
        elif found is not None and name and name not in BESIDE:
            return found
    return None
