"""A script that the unit runs does not exist or is not executable.

## What it finds
A program in Exec*= that belongs to the robot (below /usr/local, /opt, /etc, /home, /root, /srv, /var or
/data) and cannot run:

- error: it does not exist in a complete root file system;
- error: it is not executable there;
- error: it is a script without a `#!` line, also in a repository;
- warning, with medium confidence: a repository ships other files for the same folder, but not this one, and
  no step creates it.

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

import re
from collections.abc import Iterator
from typing import Any

from bringup_lint.api import Finding
from bringup_lint.api import Related
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import note
from bringup_lint.api import rule
from bringup_lint.api.systemd import Process
from bringup_lint.api.systemd import forgotten
from bringup_lint.api.systemd import is_there

OWN = re.compile(r"/(?:usr/local|opt|etc|home|root|srv|var|data)/.+")
TEXT = re.compile(r"\.(?:sh|bash|py|pl)$")


@rule("error", symptoms=["status=203/EXEC", "Failed to locate executable", "Exec format error"])
def execstartpre_missing_script(robot: Robot) -> Iterator[Finding]:
    for unit in robot.units.services:
        for process in robot.units.processes(unit):
            program = process.program
            if (
                "-" in process.prefixes
                or not OWN.match(program)
                or "$" in program
                or "%" in program
                or unit.is_opaque(process.line)
            ):
                continue
            if unit.get("RootDirectory") or unit.get("RootImage"):
                continue
            for problem, advice, related in _problems(robot, process):
                yield finding(
                    program,
                    f"{program} {problem}: {process.key}= of {unit.name} fails with 203/EXEC",
                    advice=advice,
                    related=related,
                )
            sibling = forgotten(process.program, robot)
            if sibling:
                yield finding(
                    program,
                    f"The tree ships {sibling} but not {program}: {process.key}= of {unit.name} fails "
                    "with 203/EXEC unless something else installs it",
                    advice="ship it with mode 0755",
                    severity="warning",
                    confidence="medium",
                )


def _problems(
    robot: Robot, process: Process
) -> Iterator[tuple[str, str, list[Related]] | tuple[str, str, tuple[Any, Any]]]:
    program = str(process.program)
    source = robot.tree.find(program)
    if source is None:
        if robot.tree.complete and is_there(program, robot) is False:
            yield "is not in this root file system", "ship it with mode 0755", ()
        return
    if source.mode is not None and not source.mode & 0o111:
        yield (
            f"is not executable (mode {source.mode:04o})",
            f"run chmod 0755 {program}",
            [note(source, "the script")],
        )
    first = source.text[:2]
    if source.text and not source.template and first != "#!" and TEXT.search(program):
        yield (
            "is a script without a #! line",
            "name the interpreter in the first line, for example #!/bin/bash",
            [note(source, "the script")],
        )
