"""A script that the unit runs does not exist or is not executable.

## What it finds
A program in Exec*= that belongs to the robot (below /usr/local, /opt, /etc, /home, /root, /srv, /var or
/data) and cannot run:

- error: it does not exist in a complete root file system;
- error: it is not executable there;
- error: a script or user data of the tree writes it, and nothing makes it executable, also in a repository;
- error: `install -m` of a script of the tree gives it a mode that lets nobody execute it, and nothing changes it;
- warning, with medium confidence: its mode in the repository lets nobody execute it, where other scripts have the mode
  and nothing of the tree changes it;
- warning, with medium confidence: a repository ships other files for the same folder, or its units start other
  files from the same folder of the checkout, but it does not have this one, and no step creates it; or a script of the
  tree installs the file in another folder of the system, and nowhere else.

Commands with the prefix `-` may fail and are exempt.

## Why it matters on a robot
systemd gives up with 203/EXEC. If it is the device check in ExecStartPre=, the driver never starts.

## Bad
```ini
[Service]
# no such file in the image, or mode 0644
ExecStartPre=/usr/local/bin/check-devices
ExecStart=/opt/rover/bin/drivers
```

## Good
```ini
[Service]
# shipped with mode 0755, first line #!/bin/bash
ExecStartPre=/usr/local/bin/check-devices
ExecStart=/opt/rover/bin/drivers
```

## When to ignore it
When the script comes from another package or repository that is installed in the same folder, or is generated
on the robot before the service starts.

## References
- systemd.exec(5), "Process Exit Codes": 203 EXIT_EXEC; execve(2), ENOEXEC
"""

import posixpath
from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import note
from bringup_lint.api import rule
from bringup_lint.api import shell
from bringup_lint.api.spelling import nearest
from bringup_lint.api.systemd import Defect
from bringup_lint.api.systemd import is_own_program
from bringup_lint.api.systemd import unstartable

TEXTS = {
    Defect.MISSING: ("is not in this root file system", "ship it with mode 0755"),
    Defect.NOT_EXECUTABLE: ("is not executable (mode {mode:04o})", "run chmod 0755 {program}"),
    Defect.PLAIN: (
        "is not executable in this repository, and nothing gives it the mode",
        "run git update-index --chmod=+x {name}, or chmod 0755 {program} after it is copied",
    ),
    Defect.WRITTEN: ("is written without execute permission", "run chmod 0755 {program} after it is written"),
}


@rule(
    "error",
    symptoms=[
        "status=203/EXEC",
        "Failed to locate executable",
        "Unable to locate executable",
        "Failed at step EXEC spawning",
        "Exec format error",
        "bash: *: No such file or directory",
        "sh: *: not found",
        "Failed to execute *: Permission denied",
    ],
)
def execstartpre_missing_script(robot: Robot) -> Iterator[Finding]:
    modes = shell.plain_modes(robot.scripts) if robot.of_kind("shell-script") else {}
    for unit in robot.units.services:
        for process in robot.units.processes(unit):
            if not is_own_program(process):
                continue
            program = process.program
            for defect, source in unstartable(process, robot.filesystem):
                problem, advice = TEXTS[defect]
                mode = source.mode if source and source.mode is not None else 0
                yield finding(
                    program,
                    f"{program} {problem.format(mode=mode)}: {process.key}= of {unit.name} fails with 203/EXEC",
                    advice=advice.format(program=program, name=source.name if source else ""),
                    severity="warning" if defect is Defect.PLAIN else None,
                    confidence="medium" if defect is Defect.PLAIN else None,
                    related=[note(source, "the script")] if source else (),
                )
            if program in modes:
                yield finding(
                    program,
                    f"{program} is installed with mode {modes[program]}, which lets nobody execute it: "
                    f"{process.key}= of {unit.name} fails with 203/EXEC",
                    advice="install it with mode 0755",
                    related=[note(modes[program], "installed here")],
                )
            sibling = robot.filesystem.shipped_sibling(program)
            if sibling:
                yield finding(
                    program,
                    f"The tree has {sibling} but not {program}: {process.key}= of {unit.name} fails "
                    "with 203/EXEC unless something else installs it",
                    advice="ship it with mode 0755"
                    + (f", or name {sibling}" if _may_be_meant(sibling, program) else ""),
                    severity="warning",
                    confidence="medium",
                )


def _may_be_meant(sibling: str, program: str) -> bool:
    """Whether a file has the name of a program that is missing, or nearly that."""
    name, other = posixpath.basename(program), posixpath.basename(sibling)
    return name == other or bool(nearest(name, [other]))
