"""A service of a user changes what belongs to root.

## What it finds
A service with `User=` whose script or Python program, as it starts, writes or changes a file below /etc, /boot or /usr,
or makes a folder or a log file below /var/log, /var/lib and the like: commands that surely run, without `sudo`, and
calls outside of any `try`. Not `rm -f`, and nothing in a script that starts itself again with `sudo`.

Silent where another file of the same robot names the folder below /var or gives the file to somebody, where a unit has
`StateDirectory=`, `LogsDirectory=` or the like for it, and where the service has capabilities or the line has `+`
or `!`.

## Why it matters on a robot
"Permission denied": the program ends before it does anything, and `Restart=` starts it again and again. It worked when
somebody tried the script with sudo, or while another service still made the folder.

## Bad
```ini
[Service]
User=rover
# display.py calls os.makedirs("/var/log/rover")
ExecStart=/usr/bin/python3 /opt/rover/display.py
```

## Good
```ini
[Service]
User=rover
LogsDirectory=rover
ExecStart=/usr/bin/python3 /opt/rover/display.py
```

## When to ignore it
When a step outside of the tree gives the file or folder to the user.

## References
- systemd.exec(5), User= and LogsDirectory=
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import note
from bringup_lint.api import rule
from bringup_lint.api import systemd


@rule(
    "error",
    confidence="medium",
    symptoms=["PermissionError: [Errno 13] Permission denied: '/var/", "Permission denied"],
)
def write_refused(robot: Robot) -> Iterator[Finding]:
    if not robot.of_kind("shell-script", "python-node"):
        return
    found: dict[str, list[systemd.RefusedWrite]] = {}
    for each in systemd.refused_writes(robot.filesystem, robot.scripts):
        found.setdefault(each.unit.name, []).append(each)
    for name, (first, *others) in found.items():
        yield finding(
            first.user,
            f"{name} runs as {first.user}, who may not change {first.path}: permission denied",
            advice="let systemd make the folder (LogsDirectory=, StateDirectory=), or do it in a service of root",
            related=[note(first.where, "changed here"), *(note(each.where, "and here") for each in others)],
        )
