"""A program of the robot in the background of a container.

## What it finds
`ros2 launch ... &`, `ros2 run ... &` or a server such as `MicroXRCEAgent` or `zenohd` with `&` in the command of a
container, or in its entry script, while something else keeps the container running. All jobs of a container are one
finding. Shells with `wait -n` are exempt.

## Why it matters on a robot
Docker watches the first process only. When the program in the background dies, the container keeps running, no
restart policy acts, and the robot drives on without its camera or its agent. At `docker stop` the program gets no
signal and is killed.

## Bad
```yaml
command: bash -c 'ros2 launch base camera.launch.py & ros2 launch base base.launch.py'
```

## Good
```yaml
services:
  camera:
    command: ros2 launch base camera.launch.py
  base:
    command: ros2 launch base base.launch.py
```

## When to ignore it
When the program restarts itself, and nothing has to be told at the stop.

## References
- https://docs.docker.com/engine/containers/multi-service_container/
- bash(1), "wait"
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import note
from bringup_lint.api import regex
from bringup_lint.api import rule
from bringup_lint.api.docker import Runner
from bringup_lint.api.shell import Job
from bringup_lint.api.shell import background_jobs

IDLE = regex(r"\bsleep\s+(?:infinity|inf)\b|\btail\s+-[fF]\b")


@rule("warning", silent="Docker watches the first process of a container only")
def background_job(robot: Robot) -> Iterator[Finding]:
    found: dict[object, tuple[list[Job], list[Runner]]] = {}
    for runner in robot.runners.in_containers:
        jobs = list(_jobs(runner))
        if jobs:
            found.setdefault(jobs[0].step.command.words[0].span, (jobs, []))[1].append(runner)
    for (first, *others), runners in found.values():
        more = f" ({len(others) + 1} jobs)" if others else ""
        yield finding(
            first.step.command.words[0],
            f"When this background job dies{more}, the container keeps running: nothing restarts it",
            advice="give every program a service of its own, or end the script with wait -n",
            related=[
                *(note(other.step.command.words[0], "this job too") for other in others),
                *(note(runner.where, f"{runner.name} starts it") for runner in runners),
            ],
        )


def _jobs(runner: Runner) -> Iterator[Job]:
    """The jobs that the container outlives; one that only sleeps after them is another matter."""
    for line in runner.main:
        for job in background_jobs(line):
            text = job.step.script.text if job.step.script is not None else str(line.line)
            if not job.ends and not IDLE.search(text):
                yield job
