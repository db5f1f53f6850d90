"""ProtectHome= hides files that the service needs.

## What it finds
ProtectHome=yes or ProtectHome=tmpfs, when one of these is below /home, /root or /run/user:

- the working directory, the program, a sourced workspace, or another argument;
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

import re
from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Located
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import note
from bringup_lint.api import rule
from bringup_lint.api.systemd import Sandbox
from bringup_lint.api.systemd import Unit
from bringup_lint.api.systemd import View
from bringup_lint.api.systemd import paths
from bringup_lint.api.systemd import sandbox

HOMES = ("/home", "/root", "/run/user")
BELOW = re.compile(r"(?<![\w./])/(?:home/[\w.-]+|root)(?:/[\w.@+-]+)*")
REOPENED = ("ReadWritePaths", "ReadOnlyPaths", "ExecPaths")


@rule(
    "error",
    symptoms=[
        "status=200/CHDIR",
        "Changing to the requested working directory failed",
        "status=226/NAMESPACE",
    ],
)
def protecthome_workspace(robot: Robot) -> Iterator[Finding]:
    for unit in robot.units.services:
        box = sandbox(unit, robot)
        home = box.protect_home
        if home.at is None or home.value not in ("yes", "tmpfs") or box.own_root:
            continue
        closed = [view for view in box.views if view.at is home.at]
        lists = [entry for entry in paths(unit, *REOPENED) if _is_closed(box, closed, entry.path)]
        needed = [(word, path) for word, path in _needed(unit, box, robot) if _is_closed(box, closed, path)]
        state = "hides" if home.value == "yes" else "empties"
        hard = [entry for entry in lists if not entry.optional] if home.value == "tmpfs" else []
        for word, path, _ in lists[:1]:
            yield finding(
                word,
                f"{path} is below a directory that ProtectHome={home.at} {state}: "
                + ("the service does not start, 226/NAMESPACE" if hard else "this line cannot reopen it"),
                advice="use ProtectHome=read-only, or keep the data outside of the home folders",
                related=[
                    note(home.at, f"{state} it"),
                    *(note(other.word, "cannot be reopened either") for other in lists[1:]),
                ],
            )
        if needed or lists:
            names = list(dict.fromkeys([path for _, path in needed] + [entry.path for entry in lists]))
            more = f" and {len(names) - 1} more" if len(names) > 1 else ""
            yield finding(
                home.at,
                f"ProtectHome={home.at} {state} {names[0]}{more}, which {unit.name} needs",
                advice="use ProtectHome=read-only with logs elsewhere, or install outside of the home folders",
                related=[
                    *(note(word, "needs it") for word, _ in needed),
                    *(note(entry.word, "cannot reopen it") for entry in lists),
                ],
            )


def _is_closed(box: Sandbox, closed: list[View], path: str) -> bool:
    """Whether ProtectHome= is the setting that decides on a path."""
    view = box.view(path)
    if view is None:
        return False
    if view in closed:
        return True
    return view.why in ("ReadWritePaths=", "ReadOnlyPaths=") and any(
        path.startswith(f"{home.prefix}/") for home in closed
    )


def _needed(unit: Unit, box: Sandbox, robot: Robot) -> Iterator[tuple[Located, str]]:
    folder = unit.get("WorkingDirectory")
    if folder == "~":
        home, _ = box.home()
        if home:
            yield folder, home
    elif folder and folder.startswith("/"):
        yield folder, str(folder)
    for process in robot.units.processes(unit):
        for step in process.steps:
            if step.script is None and (step.depth or not process.shell):
                for word in step.command.words:
                    for found in BELOW.finditer(word):
                        if not word.startswith("-") or "=" in word:
                            yield word.part(*found.span()), found[0]
