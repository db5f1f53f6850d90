"""A ROS program in the background of the start script.

## What it finds
`ros2 ... &` in the shell text or script of ExecStart=. It is an error when nothing keeps the shell running
after the job, and a warning otherwise. Services with Type=oneshot, Type=forking or RemainAfterExit= are
exempt.

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
from bringup_lint.api.systemd import Step

PASSING = ("echo", "printf", "true", "logger", "exit", ":", "disown")


@rule("error")
def shell_background_job(robot: Robot) -> Iterator[Finding]:
    for unit in robot.units.ros:
        remains = unit.flag("RemainAfterExit")
        if unit.get("Type") in ("oneshot", "forking") or remains or remains.unknown:
            continue
        for process in robot.units.started(unit):
            for at, step in enumerate(process.steps):
                roses = [found for other, found in process.ros if other is step and found.kind != "cli"]
                if not roses or not step.command.background:
                    continue
                ends = not any(_keeps_running(later) for later in process.steps[at + 1 :])
                yield finding(
                    step.command.words[0],
                    f"Nothing keeps the shell running after this background job: {unit.name} exits at "
                    "once, and systemd kills the job"
                    if ends and not step.command.depth
                    else f"When this background job dies, {unit.name} keeps running: systemd does not restart it",
                    advice="run it in the foreground with exec, and each process in a unit of its own",
                    related=[note(process.program, "the main process")],
                    severity="error" if ends and not step.command.depth else "warning",
                )


def _keeps_running(step: Step) -> bool:
    """Whether a later command may take its time: wait, a foreground program, a loop."""
    command = step.command
    return bool(command.words) and not command.background and command.name not in PASSING
