"""A script that the unit runs is not there, or cannot be run.

## What it finds
A script or program of one's own (below /usr/local, /opt, /etc, /home, /srv, /var or /data) in Exec*= that a
root file system does not hold, that is not executable there, or that is text without a `#!` line, also in a
repository. A repository that ships other files for the same folder, and no step that makes this one, is
warned with less confidence. A `-` in front says that it may fail.

## Why it matters on a robot
systemd gives up with 203/EXEC. When it is the device check of ExecStartPre=, the driver behind it never
starts.

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

## References
- systemd.exec(5), "Process Exit Codes": 203 EXIT_EXEC; execve(2), ENOEXEC
"""

import re

from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import note
from bringup_lint.api import rule
from bringup_lint.api.systemd import forgotten
from bringup_lint.api.systemd import is_there

OWN = re.compile(r"/(?:usr/local|opt|etc|home|root|srv|var|data)/.+")
TEXT = re.compile(r"\.(?:sh|bash|py|pl)$")


@rule("error", symptoms=["status=203/EXEC", "Failed to locate executable", "Exec format error"])
def execstartpre_missing_script(robot: Robot):
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
                    "with 203/EXEC if nobody else does",
                    advice="ship it with mode 0755",
                    severity="warning",
                    confidence="medium",
                )


def _problems(robot, process):
    program = str(process.program)
    source = robot.tree.find(program)
    if source is None:
        if robot.tree.complete and is_there(program, robot) is False:
            yield "is not in this root file system", "ship it with mode 0755", ()
        return
    if source.mode is not None and not source.mode & 0o111:
        yield (
            f"is not executable (mode {source.mode:04o})",
            f"chmod 0755 {program}",
            [note(source, "the script")],
        )
    first = source.text[:2]
    if source.text and not source.template and first != "#!" and TEXT.search(program):
        yield (
            "is a script without a #! line",
            "write the interpreter in its first line, such as #!/bin/bash",
            [note(source, "the script")],
        )
