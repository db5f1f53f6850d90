"""A program of the robot in the background of the start script.

## What it finds
`ros2 ... &`, `roslaunch ... &` or a server such as `gst-launch-1.0`, `MicroXRCEAgent` or `zenohd` with `&` in the
shell text or script of ExecStart=, and `python3 ... &`, `node ... &` or `bash -c '...' &` in the shell text itself.
It is an error when nothing keeps the shell running after the job, and a warning otherwise. All jobs of a service are
one finding. Services with Type=oneshot, Type=forking or RemainAfterExit= are exempt, and shells with `wait -n`.

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

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import note
from bringup_lint.api import rule
from bringup_lint.api.shell import Job
from bringup_lint.api.shell import background_jobs
from bringup_lint.api.systemd import Process
from bringup_lint.api.systemd import Unit


@rule("error")
def shell_background_job(robot: Robot) -> Iterator[Finding]:
    for unit in robot.units.services:
        remains = unit.flag("RemainAfterExit")
        if unit.get("Type") in ("oneshot", "forking") or remains or remains.unknown:
            continue
        for process in robot.units.started(unit):
            jobs = list(background_jobs(process))
            if jobs:
                yield _finding(unit, process, jobs)


def _finding(unit: Unit, process: Process, jobs: list[Job]) -> Finding:
    (first, ends), *others = sorted(jobs, key=lambda job: not job.ends)
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
