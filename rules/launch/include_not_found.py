"""An included launch file does not exist.

## What it finds
Includes of a file that does not exist in a package of this workspace or next to the launch file. An optional
include is a warning. `ros2 launch` commands in units, scripts, and compose services that are built from this tree, are
checked in the same way, also where a script hands them to tmux, a terminal window or an alias. Not reported: commands
whose failure is expected (`||`, `2>/dev/null`), and those of scripts that test what there is.

## Why it matters on a robot
launch aborts when it reaches the include. Nothing after it starts.

## Bad
```python
IncludeLaunchDescription(PathJoinSubstitution([FindPackageShare('my_robot'), 'launch', 'sensor.launch.py']))
```

## Good
```python
IncludeLaunchDescription(PathJoinSubstitution([FindPackageShare('my_robot'), 'launch', 'sensors.launch.py']))
```

## When to ignore it
When the build generates the file in a way that the linter does not see.

## References
- launch, `IncludeLaunchDescription`
"""

import os
from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import note
from bringup_lint.api import rule
from bringup_lint.api.launch import Launching
from bringup_lint.api.launch import Package
from bringup_lint.api.shell import may_fail
from bringup_lint.api.spelling import nearest


@rule("error", symptoms=["FileNotFoundError"])
def include_not_found(robot: Robot) -> Iterator[Finding]:
    for reference, package in robot.launch.missing("include"):
        known = [os.path.basename(each.source.name) for each in robot.launch.files_of(package)]
        near = nearest(reference.name, known, 3)
        yield finding(
            reference.span,
            f"{reference.name} does not exist in {package.name}: launch aborts",
            advice=f"include {near[0]}" if near else "correct the path",
            related=[note(package.place, f"the package {package.name}")],
            severity="warning" if reference.optional else None,
        )
    yield from commands(robot)


def commands(robot: Robot) -> Iterator[Finding]:
    for command in robot.runners.launches:
        yield from _of_command(robot, command, f"{command.runner.name} fails at every start")
    for command in robot.runners.typed_launches:
        severity = None if robot.runners.is_supervised(command.runner) else "warning"
        yield from _of_command(robot, command, "ros2 launch ends at once", severity)


def _of_command(robot: Robot, command: Launching, effect: str, severity: str | None = None) -> Iterator[Finding]:
    package = robot.launch.workspace.packages.get(command.package or "")
    if package is None or command.file is not None or not package.installs_known:
        return
    if any(sign in command.target for sign in "$%"):
        return
    if may_fail(command.start.ros.command, command.target) or _is_renamed(package, command.target):
        return
    if not command.runner.certain or robot.purpose(command.target).value == "archive":
        return
    known = [os.path.basename(each.source.name) for each in robot.launch.files_of(package)]
    if command.target in known or not command.target.endswith((".py", ".xml", ".yaml", ".yml", ".launch")):
        return
    near = nearest(command.target, known, 3)
    yield finding(
        command.target,
        f"{command.target} does not exist in {package.name}: {effect}",
        advice=f"launch {near[0]}" if near else "correct the name",
        related=[note(package.place, f"the package {package.name}")],
        chain=robot.provenance.chain_to(command.target, f"{command.target} is launched"),
        severity=severity,
    )


def _is_renamed(package: Package, name: str) -> bool:
    """Whether the build installs a launch file under this name, which has another one in the source."""
    places = (f"share/{package.name}/{folder}{name}" for folder in ("launch/", ""))
    return any(os.path.basename(origin) != name for place in places for origin in package.origins(place))
