"""A program of the robot in the background of the start script.

## What it finds
`ros2 ... &`, `roslaunch ... &` or a server such as `gst-launch-1.0`, `MicroXRCEAgent` or `zenohd` with `&` in the
shell text or script of ExecStart=, and `python3 ... &`, `node ... &` or `bash -c '...' &` in the shell text itself.
It is an error when nothing keeps the shell running after the job, and a warning otherwise. All jobs of a service are
one finding. Jobs that a service with RemainAfterExit= leaves running are a warning, and so are two and more of
Type=forking without PIDFile=. With Type=oneshot a job is reported where nothing keeps the shell running after it.
Shells with `wait -n` are exempt.

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
from bringup_lint.api import Related
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import note
from bringup_lint.api import rule
from bringup_lint.api.shell import Job
from bringup_lint.api.shell import background_jobs
from bringup_lint.api.systemd import Process
from bringup_lint.api.systemd import Step
from bringup_lint.api.systemd import Unit


@rule("error", silent="systemd watches the main process only")
def shell_background_job(robot: Robot) -> Iterator[Finding]:
    for unit in robot.units.running("&"):
        remains = unit.flag("RemainAfterExit")
        if remains.unknown:
            continue
        leaves = bool(remains) or unit.get("Type") == "forking"
        once = unit.get("Type") == "oneshot" and not leaves
        started = robot.units.started(unit)
        for process in started[-1:] if once else started:
            jobs = [job for job in background_jobs(process) if job.ends or not once]
            if once and unit.get("KillMode") in ("process", "none"):
                continue
            if jobs and not leaves:
                yield _finding(unit, process, jobs)
            elif leaves and not unit.has("PIDFile"):
                yield from _left(unit, process, jobs)


def _left(unit: Unit, process: Process, jobs: list[Job]) -> Iterator[Finding]:
    """The jobs that a command leaves running when it ends, where the unit stays active all the same. Of one job with
    Type=forking, systemd finds the main process by itself."""
    if not jobs or (len(jobs) == 1 and unit.get("Type") == "forking"):
        return
    (first, _), *others = jobs
    yield finding(
        first.command.words[0],
        f"Nothing watches this background job: when it dies, {unit.name} stays active, and nothing restarts it",
        advice="run each program in the foreground of a unit of its own, with Type=exec",
        related=[
            note(process.program, "the command that leaves it running"),
            *(note(other.command.words[0], "this job too") for other, _ in others),
        ],
        severity="warning",
    )


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
            *_waits(process, first),
        ],
        severity="error" if ends else "warning",
    )


def _waits(process: Process, job: Step) -> Iterator[Related]:
    """The ``wait`` that ends only after all jobs."""
    for step in process.steps[process.steps.index(job) + 1 :]:
        if step.command.name == "wait" and len(step.command.words) == 1:
            yield note(step.command.words[0], "returns when all jobs have ended, not when the first one does")
            return
