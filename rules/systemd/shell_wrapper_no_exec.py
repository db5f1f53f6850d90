"""A shell stays between systemd and the ROS command.

## What it finds
A script, or the text of `sh -c`, that starts a ROS 2 program without `exec`, so that the shell remains the
main process. The last command of `bash -c` is exempt, because bash runs it with exec anyway.

It is a warning with KillMode=mixed or process, and an info with any other KillMode=.

## Why it matters on a robot
With KillMode=mixed or process, only the shell gets the stop signal. ros2 launch never sees it, and its nodes
are killed with SIGKILL, or survive. With the default KillMode=, the signal reaches all of them at once.

## Bad
```bash
#!/bin/bash
source /opt/ros/jazzy/setup.bash
ros2 launch rover base.launch.py
```

## Good
```bash
#!/bin/bash
source /opt/ros/jazzy/setup.bash
exec ros2 launch rover base.launch.py
```

## When to ignore it
When the shell forwards the signal with a trap and waits for the program, for example to clean up after it.

## References
- systemd.kill(5), KillMode=mixed
- bash(1), exec
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import fix
from bringup_lint.api import note
from bringup_lint.api import rule

ALONE = ("mixed", "process")


@rule("warning", fix="unsafe", symptoms=["State 'stop-sigterm' timed out. Killing.", "with signal SIGKILL"])
def shell_wrapper_no_exec(robot: Robot) -> Iterator[Finding]:
    for unit in robot.units.ros:
        service = robot.units.supervision(unit)
        if not unit.complete or service.main is None or service.main.kind != "shell" or service.kill_mode.unknown:
            continue
        process = service.main_line
        for step, found in process.ros:
            words = step.command.words
            if found.kind == "cli" or step.command.background or words[0] == "exec" or not step.shell:
                continue
            alone = service.kill_mode.value in ALONE
            signal = service.kill_signal.value or "the signal"
            yield finding(
                words[0],
                f"The shell stays the main process of {unit.name}: "
                + (
                    f"on stop only the shell gets {signal}, not this command"
                    if alone
                    else "systemd watches the shell, not this command"
                ),
                advice="start the command with exec"
                if step.last
                else "make it the last command and start it with exec",
                related=[
                    note(process.program, "the main process"),
                    *(
                        [note(service.kill_mode.at, "only the main process gets the signal")]
                        if alone and service.kill_mode.at
                        else ()
                    ),
                ],
                fix=fix("add exec", (words[0].part(0, 0), "exec "))
                if step.last and not step.command.assignments
                else None,
                severity="warning" if alone else "info",
            )
