"""A container installs packages each time that it starts.

## What it finds
A service whose `command:`, or whose entry script in the tree, runs `apt-get update`, `apt-get install` or `pip install`
before it starts ROS, so that its failure keeps ROS down. Silent for what runs under a condition or may fail, for files
that apt and pip install, also without their dependencies, and for services in which somebody works.

## Why it matters on a robot
Each new container needs the Internet, and a robot in the field often has none: the command ends with "Temporary failure
resolving", and ROS does not start. With a network, the start takes minutes, and yesterday's versions are not today's.

## Bad
```yaml
command: bash -c "apt-get update && apt-get install -y ros-jazzy-joy && ros2 run joy joy_node"
```

## Good
```dockerfile
RUN apt-get update && apt-get install -y ros-jazzy-joy && rm -rf /var/lib/apt/lists/*
```

## When to ignore it
When the robot always has the Internet, and may start late.

## References
- https://docs.docker.com/build/concepts/overview/
"""

import re
from collections.abc import Iterator
from itertools import takewhile

from bringup_lint.api import Finding
from bringup_lint.api import Located
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import note
from bringup_lint.api import regex
from bringup_lint.api import rule
from bringup_lint.api.compose import is_workplace
from bringup_lint.api.docker import CommandLine
from bringup_lint.api.shell import STRICT
from bringup_lint.api.shell import program_name
from bringup_lint.api.shell import unwrapped
from bringup_lint.api.systemd import Step

APT = ("apt", "apt-get")
OFFLINE = {"--no-deps", "--no-index", "--no-build-isolation"}
PIP = ("pip", "pip3")
STOPS = regex(STRICT, re.M)


@rule("warning", symptoms=["Temporary failure resolving", "Failed to establish a new connection"])
def installs_at_start(robot: Robot) -> Iterator[Finding]:
    seen = set()
    for runner in robot.runners.all:
        service = runner.service
        if service is None or is_workplace(robot.compose, service):
            continue
        for line in runner.main:
            word = _installs(line)
            if word is not None and word.span not in seen:
                seen.add(word.span)
                yield finding(
                    word,
                    f"{runner.name} fetches packages at each start of a new container: without the Internet, ROS does"
                    " not start",
                    advice="install them in the Dockerfile",
                    related=[note(runner.where, "starts it")] if word.span.source is not runner.source else (),
                )


def _installs(line: CommandLine) -> Located | None:
    """The first installation of which the start of ROS depends."""
    if not line.ros:
        return None
    first = line.ros[0][0]
    before = takewhile(lambda step: step is not first, line.steps)
    pairs = zip((None, *line.steps), before)
    return next(
        (step.command.words[0] for last, step in pairs if _fetches(step) and _ends_with(step) and not _is_else(last)),
        None,
    )


def _is_else(last: Step | None) -> bool:
    """Whether a command only runs where the one before it fails."""
    return last is not None and last.command.ends == "||"


def _fetches(step: Step) -> bool:
    words = unwrapped(step.command.words)
    if not words or step.command.depth:
        return False
    name, rest = program_name(words[0]), set(map(str, words[1:]))
    if any(word.endswith((".deb", ".whl")) for word in rest):
        return False
    if name in APT:
        return bool({"update", "install"} & rest)
    return name in PIP and "install" in rest and not OFFLINE & rest


def _ends_with(step: Step) -> bool:
    """Whether a failure ends what comes after it."""
    strict = step.script is not None and STOPS.search(step.script.text) is not None
    return step.command.ends == "&&" or (strict and step.command.ends not in ("||", "|", "&"))
