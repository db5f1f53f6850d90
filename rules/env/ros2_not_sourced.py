"""ROS 2 is started without its setup file.

## What it finds
Two mistakes in services:

- A service starts `ros2` or an executable of a workspace, and nothing before it sources a setup file. Silent if a
  script that is not in the tree may source it, or if the environment sets `AMENT_PREFIX_PATH`.
- `ExecStartPre=` sources a setup file, but `ExecStart=` does not. The setup applies only to the process of
  `ExecStartPre=`.

## Why it matters on a robot
`ros2` is a Python program that works only with the variables that `setup.bash` sets. Without them it exits at once
with `ModuleNotFoundError: No module named 'ros2cli'`, five times within a second, and then systemd gives up. Every
`Exec` line is a separate process: whatever it sources is gone when the next one starts.

## Bad
```ini
[Service]
ExecStartPre=/bin/bash -c 'source /opt/ros/jazzy/setup.bash'
ExecStart=/opt/ros/jazzy/bin/ros2 launch rover_bringup rover.launch.py
```

## Good
```ini
[Service]
ExecStart=/bin/bash -c 'source /opt/ros/jazzy/setup.bash && exec ros2 launch rover_bringup rover.launch.py'
```

## When to ignore it
When the program is a wrapper with the same name that sources the setup file itself.

## References
- systemd.service(5), "ExecStartPre="
- ROS 2 documentation, "Configuring environment"
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Fix
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import fix
from bringup_lint.api import note
from bringup_lint.api import regex
from bringup_lint.api import rule
from bringup_lint.api.systemd import Process
from bringup_lint.api.systemd import Ros
from bringup_lint.api.systemd import Step
from bringup_lint.api.systemd import Unit

ENOUGH = ("AMENT_PREFIX_PATH", "PYTHONPATH", "LD_LIBRARY_PATH", "BASH_ENV")
INTERPRETER = regex(r"python[0-9.]*$")
EXITS = "it exits with \"No module named 'ros2cli'\""
FINDS_NOTHING = "it finds no ROS packages or libraries"
DISTRO = regex(r"/opt/ros/[a-z]+")


@rule(
    "error",
    fix="unsafe",
    symptoms=[
        "ros2: command not found",
        "ModuleNotFoundError: No module named 'ros2cli'",
        "Package '*' not found: \"package '*' not found, searching:",
    ],
)
def ros2_not_sourced(robot: Robot) -> Iterator[Finding]:
    units = robot.units
    for unit in units.services:
        lost = [process for process in units.processes(unit) if process.key == "ExecStartPre" and sources_only(process)]
        started = units.started(unit)
        if lost and started and not any(process.setup_files for process in started):
            yield _gone(lost, started[0])
            continue
        for process in started:
            yield from _unsourced(robot, unit, process, lost)


def _gone(lost: list[Process], starts: Process) -> Finding:
    (_, word), *others = (process.setup_files[0] for process in lost)
    return finding(
        word,
        "ExecStartPre= is a separate process: what it sources is gone when ExecStart= starts",
        advice="source the setup files in the ExecStart= line itself",
        related=[
            note(starts.program, "starts without them"),
            *(note(other, "sourced here, for a process that exits at once") for _, other in others),
        ],
    )


def _unsourced(robot: Robot, unit: Unit, process: Process, lost: list[Process]) -> Iterator[Finding]:
    environment = robot.units.environment(unit)
    if process.profiles or unit.unsure_of() or any(environment.get(name) for name in ENOUGH):
        return
    found = [(step, ros) for step, ros in process.ros if not process.sourced_before(step)]
    if found and is_bare(process, found[0][1]):
        return
    if found and not hidden(process, *found[0]):
        step, ros = found[0]
        name = ros.program.rpartition("/")[2]
        yield finding(
            ros.program,
            f"Nothing sources a setup file before {name}: {EXITS if name == 'ros2' else FINDS_NOTHING}",
            advice="start it with /bin/bash -c 'source /opt/ros/<distro>/setup.bash && exec ...'",
            related=[note(process.program, f"{unit.name} starts it here")] if step.script else (),
            fix=_fix(process, step),
            confidence="high" if environment.complete else "medium",
        )
    elif lost and not found and INTERPRETER.match(process.name) and not process.setup_files:
        yield finding(
            process.program,
            f"{unit.name} starts without the ROS environment: only ExecStartPre= sources a setup file",
            advice="start it with /bin/bash -c 'source /opt/ros/<distro>/setup.bash && exec ...'",
            related=[note(lost[0].setup_files[0][1], "sourced here, for a process that exits at once")],
        )


def sources_only(process: Process) -> bool:
    """Whether the line sources setup files and does nothing with them."""
    last = process.steps[-1].command.name
    return bool(process.setup_files) and last in ("source", ".")


def is_bare(process: Process, ros: Ros) -> bool:
    """Whether systemd itself looks for ``ros2``, which systemd/exec-bare-ros2 finds."""
    return ros.program == "ros2" and ros.program.span == process.program.span


def hidden(process: Process, step: Step, ros: Ros) -> bool:
    """Whether something that runs before the program and is not in the tree may source a setup file."""
    return process.opaque and (process.steps.index(step) > 0 or ros.command is not step.command)


def _fix(process: Process, step: Step) -> Fix | None:
    match = DISTRO.match(process.program)
    if step.depth or not match or "'" in process.line or process.prefixes:
        return None
    line = f"/bin/bash -c 'source {match[0]}/setup.bash && exec {process.line}'"
    return fix("source the setup file first", (process.line, line), safe=False)
