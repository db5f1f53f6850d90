"""A program of the robot in the background of the start script.

## What it finds
`ros2 ... &` or `roslaunch ... &` in the shell text or script of ExecStart=, and `python3 ... &`, `node ... &` or
`bash -c '...' &` in the shell text itself. It is an error when nothing keeps the shell running after the job, and
a warning otherwise. All jobs of a service are one finding. Services with Type=oneshot, Type=forking or
RemainAfterExit= are exempt, and shells with `wait -n`.

## Why it matters on a robot
The shell is the main process. When it exits, systemd considers the service finished and kills the job. When
it keeps running, for example with `wait`, the crash of a job goes unnoticed, and Restart= has no effect.

## Bad
```ini
[Service]
ExecStart=/bin/bash -c 'source /opt/ros/jazzy/setup.bash; ros2 launch rover base.launch.py &'
```

## Good
```ini
[Service]
ExecStart=/bin/bash -c 'source /opt/ros/jazzy/setup.bash && exec ros2 launch rover base.launch.py'
```
and a unit of its own for every further process.

## When to ignore it
When the shell waits for every job and exits when one of them does, for example with `wait -n`.

## References
- systemd.service(5), Type=simple; systemd.kill(5)
"""

import re
from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import note
from bringup_lint.api import rule
from bringup_lint.api.shell import program_name
from bringup_lint.api.shell import unwrapped
from bringup_lint.api.systemd import Process
from bringup_lint.api.systemd import Step
from bringup_lint.api.systemd import Unit

PASSING = ("echo", "printf", "true", "logger", "exit", ":", "disown")
_LASTING = re.compile(r"roslaunch|rosrun|roscore|python[\d.]*|node|nodejs|npm|(?:ba|da|z)?sh")


@rule("error")
def shell_background_job(robot: Robot) -> Iterator[Finding]:
    for unit in robot.units.services:
        remains = unit.flag("RemainAfterExit")
        if unit.get("Type") in ("oneshot", "forking") or remains or remains.unknown:
            continue
        for process in robot.units.started(unit):
            jobs = list(_jobs(process))
            if jobs:
                yield _finding(unit, process, jobs)


def _jobs(process: Process) -> Iterator[tuple[Step, bool]]:
    """The programs in the background, and whether the shell ends with the job still running."""
    if any(step.command.name == "wait" and "-n" in step.command.words for step in process.steps):
        return
    for at, step in enumerate(process.steps):
        if step.command.background and _lasts(process, step):
            ends = not any(_keeps_running(later) for later in process.steps[at + 1 :])
            yield step, ends and not step.command.depth


def _lasts(process: Process, step: Step) -> bool:
    """Whether a job is a program of the robot: of ROS, or an interpreter that the command line itself starts."""
    if any(other is step and found.kind != "cli" for other, found in process.ros):
        return True
    words = unwrapped(step.command.words)
    name = program_name(words[0]) if words else ""
    return bool(_LASTING.fullmatch(name)) and (step.script is None or name.startswith("ros"))


def _finding(unit: Unit, process: Process, jobs: list[tuple[Step, bool]]) -> Finding:
    (first, ends), *others = sorted(jobs, key=lambda job: not job[1])
    more = f" ({len(jobs)} jobs)" if others else ""
    return finding(
        first.command.words[0],
        f"Nothing keeps the shell running after this background job{more}: {unit.name} exits at "
        "once, and systemd kills the job"
        if ends
        else f"When this background job dies{more}, {unit.name} keeps running: systemd does not restart it",
        advice="run it in the foreground with exec, and each process in a unit of its own",
        related=[
            note(process.program, "the main process"),
            *(note(other.command.words[0], "this job too") for other, _ in others),
        ],
        severity="error" if ends else "warning",
    )


def _keeps_running(step: Step) -> bool:
    """Whether a later command may take its time: wait, a foreground program, a loop."""
    command = step.command
    return bool(command.words) and not command.background and command.name not in PASSING
