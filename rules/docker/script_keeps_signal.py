"""An entry script does not pass the stop signal on.

## What it finds
A script of the tree that a container starts and that runs ROS in the foreground without `exec`, or in the background
while it keeps the container running with `sleep infinity` or `tail -f`; one that ends with `"$@"` without `exec` and is
given a command that starts ROS, also one in shell form; and one that ends so where a service of the tree starts ROS.
Silent if the script sets a `trap`, and under an init program that signals the whole group (`dumb-init`, `tini -g`).

## Why it matters on a robot
docker stop signals the first process only. That is the shell, which waits for ROS and does not pass the signal on:
after the grace period Docker kills all nodes at once, and no driver stops its motors. A script that sleeps also hides
the end of ROS: the container keeps running, and no restart policy acts.

## Bad
```sh
source /opt/ros/jazzy/setup.bash
ros2 launch base base.launch.py
```

## Good
```sh
source /opt/ros/jazzy/setup.bash
exec ros2 launch base base.launch.py
```

## When to ignore it
When the nodes may be killed at any time, as in a container that only records.

## References
- https://docs.docker.com/reference/dockerfile/#exec-form-entrypoint-example
- bash(1), "SIGNALS"
"""

import re
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
from bringup_lint.api.docker import CommandLine
from bringup_lint.api.docker import Runner
from bringup_lint.api.systemd import Ros
from bringup_lint.api.systemd import Step

GROUP = regex(r"dumb-init|tini\b.*\s-g\b")
GIVEN = regex(r"^[ \t]*(\"\$@\"|\$@|\$\*)[ \t]*$", re.M)
FOREVER = regex(r"\bsleep\s+(?:infinity|inf)\b|\btail\s+-[fF]\b")


@rule("warning", symptoms=["exited with code 137"])
def script_keeps_signal(robot: Robot) -> Iterator[Finding]:
    found: dict[object, tuple[Step, Ros, list[Runner]]] = {}
    for runner in robot.runners.in_containers:
        for step, ros in _kept(runner):
            found.setdefault(ros.where.span, (step, ros, []))[2].append(runner)
    for step, ros, runners in found.values():
        related = [note(runner.where, f"{runner.name} starts the script") for runner in runners]
        related += _given_at(step, ros)
        script = step.script.basename if step.script is not None else "the script"
        if step.command.background:
            message = (
                f"{script} sleeps while ROS runs in the background: its end is not noticed, and no signal reaches it"
            )
            advice = "start it last, with exec, and remove the sleep"
        else:
            message = f"{script} runs ROS without exec: docker stop signals the shell, and Docker kills the nodes"
            advice = "write exec in front of it"
        yield finding(ros.where, message, advice=advice, related=related)
    yield from _handing(robot, {step.script for step, _, _ in found.values()})


def _given_at(step: Step, ros: Ros) -> Iterator[Related]:
    """Where the script runs the command that it is given, which is written elsewhere."""
    script = step.script
    match = GIVEN.search(script.text) if script is not None and ros.where.span.source is not script else None
    if script is not None and match is not None:
        yield note(script.located(*match.span(1)), "runs the command that it is given")


def _handing(robot: Robot, said: set[Source | None]) -> Iterator[Finding]:
    """Entry scripts that start as their child whatever command they are given."""
    scripts: dict[Source, tuple[Located, list[Runner]]] = {}
    for runner in robot.runners.in_containers:
        for step in _given(runner):
            if step.script is not None and step.script not in said:
                scripts.setdefault(step.script, (step.command.words[0], []))[1].append(runner)
    for script, (word, runners) in scripts.items():
        if any("ros2" in " ".join(service.command) for service in robot.compose.services):
            yield finding(
                word,
                f"{script.basename} runs its command without exec: docker stop signals the shell, and Docker kills ROS",
                advice='write exec "$@"',
                related=[note(runner.where, f"{runner.name} starts the script") for runner in runners],
            )


def _given(runner: Runner) -> Iterator[Step]:
    """The end of an entry script that runs its arguments, where nothing says which these are."""
    for line in runner.main:
        if GROUP.search(" ".join(line.argv)) or GROUP.search(str(line.line)):
            continue
        for step in line.steps:
            if step.last and step.command.words == ("$@",) and not _is_handed_on(step):
                yield step


def _kept(runner: Runner) -> Iterator[tuple[Step, Ros]]:
    for line in runner.main:
        if GROUP.search(" ".join(line.argv)) or GROUP.search(str(line.line)):
            continue
        for step, ros in line.ros:
            starter = step if step.script is not None else _starter(line, step)
            if starter is not None and ros.kind in ("launch", "run") and not _is_handed_on(starter):
                yield starter, ros


def _starter(line: CommandLine, step: Step) -> Step | None:
    """The command of a script that starts the shell in which ROS runs: what the script is given in shell form."""
    before = line.steps[: line.steps.index(step)]
    outer = next((each for each in reversed(before) if each.depth < step.depth), None)
    return outer if outer is not None and outer.script is not None else None


def _is_handed_on(step: Step) -> bool:
    """The program replaces its shell, or the script passes signals on itself; what ends at once needs neither."""
    words = step.command.words
    text = step.script.text if step.script is not None else ""
    if str(words[0]) == "exec" or step.command.depth or re.search(r"^\s*trap\b", text, re.M):
        return True
    if step.command.background:
        return not FOREVER.search(text)
    return step.command.ends in ("|", "||")
