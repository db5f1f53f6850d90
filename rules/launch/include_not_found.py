"""An included launch file does not exist.

## What it finds
Includes of a file that does not exist in a package of this workspace or next to the launch file. An optional
include is a warning. `ros2 launch` commands in units, and in compose services that are built from this tree, are
checked in the same way.

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
        package = robot.launch.workspace.packages.get(command.package or "")
        if package is None or command.file is not None or not package.installs_known:
            continue
        if any(sign in command.target for sign in "$%"):
            continue
        if not command.runner.certain or robot.purpose(command.target).value == "archive":
            continue
        known = [os.path.basename(each.source.name) for each in robot.launch.files_of(package)]
        if command.target in known or not command.target.endswith((".py", ".xml", ".yaml", ".yml", ".launch")):
            continue
        near = nearest(command.target, known, 3)
        yield finding(
            command.target,
            f"{command.target} does not exist in {package.name}: {command.runner.name} fails at every start",
            advice=f"launch {near[0]}" if near else "correct the name",
            related=[note(package.place, f"the package {package.name}")],
            chain=robot.provenance.chain_to(command.target, f"{command.target} is launched"),
        )
