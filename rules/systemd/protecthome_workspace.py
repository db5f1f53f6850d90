"""ProtectHome= hides files that the service needs.

## What it finds
ProtectHome=yes or ProtectHome=tmpfs, when one of these is below /home, /root or /run/user:

- the working directory, the program, a sourced workspace, or another argument;
- a file of settings that a variable of the environment names;
- a path in ReadWritePaths=, ReadOnlyPaths= or ExecPaths=, which cannot reopen a hidden directory.

## Why it matters on a robot
The service fails with 200/CHDIR or 203/EXEC, or setup.bash is "not found" although it exists. With
ProtectHome=tmpfs, a path in ReadWritePaths= makes the start fail with 226/NAMESPACE.

## Bad
```ini
[Service]
User=rover
WorkingDirectory=/home/rover/ws
ProtectHome=yes
```

## Good
```ini
[Service]
User=rover
WorkingDirectory=/opt/rover
LogsDirectory=ros2
Environment=ROS_LOG_DIR=/var/log/ros2
ProtectHome=yes
```
or ProtectHome=read-only, if the service only reads there.

## When to ignore it
When the argument is only a name that the program does not open, or a file that it can do without.

## References
- systemd.exec(5), ProtectHome= and InaccessiblePaths=
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import note
from bringup_lint.api import rule
from bringup_lint.api.systemd import hidden_home

REFUSED = "the service does not start, 226/NAMESPACE"


@rule(
    "error",
    symptoms=[
        "status=200/CHDIR",
        "Changing to the requested working directory failed",
        "Failed at step CHDIR spawning",
        "status=226/NAMESPACE",
    ],
)
def protecthome_workspace(robot: Robot) -> Iterator[Finding]:
    for unit in robot.units.services:
        home = hidden_home(unit, robot.units)
        if home is None:
            continue
        state = "empties" if home.emptied else "hides"
        lists = home.reopened
        if not (home.needed or lists):
            continue
        names = list(dict.fromkeys([path for _, path in home.needed] + [entry.path for entry in lists]))
        more = f" and {len(names) - 1} more" if len(names) > 1 else ""
        yield finding(
            home.at,
            f"ProtectHome={home.at} {state} {names[0]}{more}, which {unit.name} needs"
            + (f": {REFUSED}" if home.prevents_start else ""),
            advice="use ProtectHome=read-only with logs elsewhere, or install outside of the home folders",
            related=[
                *(note(word, "needs it") for word, _ in home.needed),
                *(note(entry.word, "cannot reopen it") for entry in lists),
            ],
        )
