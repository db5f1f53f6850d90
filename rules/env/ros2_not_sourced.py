"""ROS 2 is started without its setup file.

## What it finds
Two mistakes in services, and two in other shells:

- A service starts `ros2` or an executable of a workspace, and nothing before it sources a setup file. Silent if a
  script that is not in the tree may source it, or if the environment sets `AMENT_PREFIX_PATH`.
- `ExecStartPre=` sources a setup file, but `ExecStart=` does not. The setup applies only to the process of
  `ExecStartPre=`.
- A task of Ansible starts `ros2` with `shell` or `command`, sources no setup file, and neither it nor its play
  sets an `environment:`. Ansible's shell is not interactive: Ubuntu's `.bashrc` returns before its last lines.
- A line of a crontab, also one that a script adds, starts `ros2` in the same way.

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

import re
from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Fix
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import fix
from bringup_lint.api import note
from bringup_lint.api import regex
from bringup_lint.api import rule
from bringup_lint.api.systemd import NotSourced
from bringup_lint.api.systemd import Process
from bringup_lint.api.systemd import SourcedBefore
from bringup_lint.api.systemd import Step
from bringup_lint.api.systemd import unsourced

EXITS = "it exits with \"No module named 'ros2cli'\""
FINDS_NOTHING = "it finds no ROS packages or libraries"
IN_ONE_LINE = "start it with /bin/bash -c 'source /opt/ros/<distro>/setup.bash && exec ...'"
TASK = regex(
    r"^[ \t]*(?:-[ \t]+)?(?:ansible\.builtin\.)?(?:shell|command):[ \t]*(?P<program>ros2)[ \t]+"
    r"(?:run|launch|topic|param|service|node|pkg|daemon|security)\b",
    re.M,
)
SOURCED = regex(r"setup\.(?:ba|z)?sh|AMENT_PREFIX_PATH|^[ \t]*environment:", re.M)
OF_PLAY = regex(r"^  environment:", re.M)
DISTRO = regex(r"/opt/ros/[a-z]+")


@rule(
    "error",
    fix="unsafe",
    symptoms=[
        "Package '*' not found: \"package '*' not found, searching:",
        "ros2: command not found",
        "ModuleNotFoundError: No module named 'ros2cli'",
        "Failed to load entry point 'launch': No module named 'launch_ros'",
        "error while loading shared libraries: lib*.so: cannot open shared object file",
        "error while loading shared libraries: lib*.so.* cannot open shared object file",
        "ImportError: lib*.so: cannot open shared object file",
        "exec: ros2: not found",
    ],
)
def ros2_not_sourced(robot: Robot) -> Iterator[Finding]:
    for each in unsourced(robot.units):
        if isinstance(each, NotSourced):
            yield _not_sourced(each)
        elif each.every:
            yield _sourced_before(each)
        else:
            yield finding(
                each.start.program,
                f"{each.unit.name} starts without the ROS environment: only ExecStartPre= sources a setup file",
                advice=IN_ONE_LINE,
                related=[note(each.sourcing[0].setup_files[0][1], "sourced here, for a process that exits at once")],
            )
    for program in robot.bare_jobs:
        yield finding(
            program,
            "The shell of cron reads no login file: without a setup file, ros2 is not found",
            advice="write '. /opt/ros/<distro>/setup.sh && ros2 ...'",
            confidence="medium",
        )
    for source in robot.of_kind("ansible"):
        started = next((each for each in TASK.finditer(source.text) if source.judged and not _is_set(each)), None)
        if started is not None:
            yield finding(
                source.located(*started.span("program")),
                "The shell of Ansible has no ROS environment: ros2 is not found",
                advice="write '. /opt/ros/<distro>/setup.bash && ros2 ...' with executable: /bin/bash",
                confidence="medium",
            )


def _is_set(started: re.Match[str]) -> bool:
    """Whether the task, or the play above it, sets the environment."""
    text = started.string
    before, after = text[: started.start()].rpartition("\n- ")[2], text[started.start() :].partition("\n- ")[0]
    return SOURCED.search(before + after) is not None or OF_PLAY.search(text) is not None


def _sourced_before(found: SourcedBefore) -> Finding:
    (_, word), *others = (process.setup_files[0] for process in found.sourcing)
    return finding(
        word,
        "ExecStartPre= is a separate process: what it sources is gone when ExecStart= starts",
        advice="source the setup files in the ExecStart= line itself",
        related=[
            note(found.start.program, "starts without them"),
            *(note(other, "sourced here, for a process that exits at once") for _, other in others),
        ],
    )


def _not_sourced(found: NotSourced) -> Finding:
    name = found.ros.program.rpartition("/")[2]
    return finding(
        found.ros.program,
        f"Nothing sources a setup file before {name}: {EXITS if name == 'ros2' else FINDS_NOTHING}",
        advice=IN_ONE_LINE,
        related=[note(found.process.program, f"{found.unit.name} starts it here")] if found.step.script else (),
        fix=_fix(found.process, found.step),
        confidence="high" if found.certain else "medium",
    )


def _fix(process: Process, step: Step) -> Fix | None:
    match = DISTRO.match(process.program)
    if step.depth or not match or "'" in process.line or process.prefixes:
        return None
    line = f"/bin/bash -c 'source {match[0]}/setup.bash && exec {process.line}'"
    return fix("source the setup file first", (process.line, line), safe=False)
