"""Nothing creates the working directory of a service.

## What it finds
A `WorkingDirectory=` without `-` below /var/lib, /var/log, /run and similar folders, where nothing exists by default,
that nothing in the tree creates: no StateDirectory= or similar setting, no tmpfiles.d line, no mount, no home of a
user, no script and no play.

## Why it matters on a robot
systemd changes to the directory before it starts the program: 200/CHDIR, whatever the program needs it for. On the
developer's robot somebody made the directory by hand once.

## Bad
```ini
[Service]
WorkingDirectory=/var/lib/rover
ExecStart=/opt/rover/bin/recorder
```

## Good
```ini
[Service]
StateDirectory=rover
WorkingDirectory=/var/lib/rover
ExecStart=/opt/rover/bin/recorder
```

## When to ignore it
When a package or a step that is not in this tree creates the directory.

## References
- systemd.exec(5), WorkingDirectory= and StateDirectory=
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import rule
from bringup_lint.api.systemd import line_to_create


@rule(
    "warning",
    confidence="medium",
    symptoms=[
        "status=200/CHDIR",
        "Changing to the requested working directory failed",
        "Failed at step CHDIR spawning",
    ],
)
def workdir_missing(robot: Robot) -> Iterator[Finding]:
    for unit in robot.units.services:
        path = unit.get("WorkingDirectory")
        if path is None or not path.startswith("/") or "%" in path or unit.uncertain or unit.has("RootDirectory"):
            continue
        folder = path.rstrip("/")
        if robot.filesystem.is_made(folder) is False and not robot.units.is_distribution_unit(unit.name):
            yield finding(
                path,
                f"Nothing creates {folder}: {unit.name} does not start, 200/CHDIR",
                advice=_advice(folder),
            )


def _advice(folder: str) -> str:
    made = line_to_create(folder)
    return f"let systemd create it with {made}" if made else "create it with tmpfiles.d"
