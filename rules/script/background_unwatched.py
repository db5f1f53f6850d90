"""A script leaves all that it starts in the background.

## What it finds
A script that starts several ROS programs with `&` and ends, or sleeps, without `wait`, `trap` or a last program in the
foreground. Scripts that a unit or a container starts belong to systemd/shell-background-job and docker/background-job.

## Why it matters on a robot
When the driver of the lidar dies, nobody notices and nothing starts it again: the robot drives on without it. Ctrl-C
stops none of the programs, and starting the script a second time starts every node twice.

## Bad
```sh
ros2 launch rover base.launch.py > base.log 2>&1 &
sleep 5
ros2 launch rover nav.launch.py > nav.log 2>&1 &
```

## Good
```sh
exec ros2 launch rover everything.launch.py
```

## When to ignore it
When another script of the robot watches the programs and stops them.

## References
- bash(1), "JOB CONTROL" and "wait"
- systemd.service(5), Restart=
"""

import re
from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import Source
from bringup_lint.api import finding
from bringup_lint.api import note
from bringup_lint.api import regex
from bringup_lint.api import rule
from bringup_lint.api.docker import Runner
from bringup_lint.api.shell import Run

WATCHES = regex(r"^[^#\n]*\b(?:wait|trap|fg|tail -[fF]|while|until|systemd-run|\$!)", re.M)
LEAST = 3
"""Programs that somebody would rather start with one launch file."""


@rule("warning", confidence="medium", silent="nobody waits for the process, so nobody reports its end")
def background_unwatched(robot: Robot) -> Iterator[Finding]:
    for source in robot.of_kind("shell-script"):
        if not source.judged or source.template or "&" not in source.text or WATCHES.search(source.text):
            continue
        runs = [did for did in robot.scripts.done(source) if isinstance(did, Run)]
        jobs = [run for run in runs if run.certain and _starts_ros(run) and run.command.background]
        if len(jobs) < LEAST or any(_starts_ros(run) and not run.command.background for run in runs):
            continue
        if any(runner.in_container or runner.unit is not None for runner in _runners(robot, source)):
            continue
        first, *others = jobs
        yield finding(
            first.words[0],
            f"Nothing watches the {len(jobs)} programs that this script leaves behind: one that dies stays away",
            advice="start them from one launch file, or from units with Restart=",
            related=[note(other.words[0], "and this one") for other in others[:10]],
        )


def _starts_ros(run: Run) -> bool:
    return run.name == "ros2" and run.arguments[:1] in (["launch"], ["run"])


def _runners(robot: Robot, source: Source) -> Iterator[Runner]:
    """The runners of the same robot whose files name the script."""
    named = re.compile(rf"(?<![\w.-]){re.escape(source.basename)}\b")
    for runner in robot.runners.all:
        if named.search(runner.source.text) and robot.same_robot(runner.source, source):
            yield runner
