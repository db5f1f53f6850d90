"""An included launch file does not exist.

## What it finds
Includes of a file that does not exist in a package of this workspace or next to the launch file. An optional include
is a warning. `ros2 launch` commands in units, scripts and compose services are checked in the same way, also where a
script hands them to tmux, a terminal window or an alias, or a variable of the unit names the file; a service whose
image is not built here is a warning, and needs another one with this image that launches a file of the tree. Also a
package that is not in the tree, where its name is nearly that of one, or where it is one of a family of the tree and
its service has the image of services that launch others of the family. Not reported: commands whose failure is
expected (`||`, `2>/dev/null`), and those of scripts that test what there is.

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
from bringup_lint.api import Located
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import launch
from bringup_lint.api import note
from bringup_lint.api import regex
from bringup_lint.api import rule
from bringup_lint.api.launch import Launching
from bringup_lint.api.launch import Package
from bringup_lint.api.shell import may_fail
from bringup_lint.api.spelling import nearest

PLAIN = regex(r"[a-z]\w*\Z")
VARIABLE = regex(r"[\"']?\$(?:(?P<plain>\w+)|\{(?P<braced>\w+)(?::?-[^}]*)?\})[\"']?", hints="$")
FILE = regex(r"[\w.-]+\.(?:py|xml|ya?ml|launch)")
FAMILY = 6
"""Packages of the tree whose names begin alike, so that the family is here as a whole."""


@rule("error", symptoms=["FileNotFoundError"])
def include_not_found(robot: Robot) -> Iterator[Finding]:
    for reference, package in robot.launch.missing("include"):
        known = [os.path.basename(each.source.name) for each in robot.launch.files_of(package)]
        near = [reference.name] if reference.name in known else nearest(reference.name, known, 3)
        yield finding(
            reference.where,
            f"{reference.name} does not exist in {package.name}: launch aborts",
            advice=f"include {launch.path_of(robot.launch, near[0], package)}" if near else "correct the path",
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
    if "$" in command.target:
        yield from _of_variables(robot, command, effect)
        return
    if package is None:
        yield from _without_package(robot, command, effect)
        return
    if command.file is not None or "%" in command.target:
        return
    if not robot.launch.workspace.lacks_file(package, command.target):
        return
    if may_fail(command.start.ros.command, command.target) or _is_renamed(package, command.target):
        return
    is_same = command.runner.certain or bool(_of_same_image(robot, command))
    if not is_same or robot.purpose(command.target).value == "archive":
        return
    known = [os.path.basename(each.source.name) for each in robot.launch.files_of(package)]
    if command.target in known or not command.target.endswith((".py", ".xml", ".yaml", ".yml", ".launch")):
        return
    if launch.path_of(robot.launch, command.target, package) != command.target:
        return
    near = nearest(command.target, known, 3)
    yield finding(
        command.target,
        f"{command.target} does not exist in {package.name}: {effect}",
        advice=f"launch {near[0]}" if near else "correct the name",
        related=[note(package.place, f"the package {package.name}")],
        chain=robot.provenance.chain_to(command.target, f"{command.target} is launched"),
        severity=severity if command.runner.certain else "warning",
        confidence=None if command.runner.certain else "medium",
    )


def _of_variables(robot: Robot, command: Launching, effect: str) -> Iterator[Finding]:
    """A launch file that variables of the environment name."""
    environment = command.start.environment
    if command.package is None:
        return
    name, owner = environment.expand(command.target), environment.expand(command.package)
    package = robot.launch.workspace.packages.get(owner or "")
    if name is None or package is None or not package.installs_known or not command.runner.certain:
        return
    known = [os.path.basename(each.source.name) for each in robot.launch.files_of(package)]
    given = VARIABLE.fullmatch(command.target)
    variable = environment.get(given["plain"] or given["braced"]) if given is not None else None
    if name in known or not FILE.fullmatch(name) or may_fail(command.start.ros.command, command.target):
        return
    if variable is None or variable.text != name or _is_renamed(package, name):
        return
    near = nearest(name, known, 3)
    yield finding(
        variable.value,
        f"{name} does not exist in {package.name}: {effect}",
        advice=f"name {near[0]}" if near else "correct the name",
        related=[note(command.target, "launched here"), note(package.place, f"the package {package.name}")],
        confidence="medium",
    )


def _without_package(robot: Robot, command: Launching, effect: str) -> Iterator[Finding]:
    name, workspace = command.package, robot.launch.workspace
    if name is None or not PLAIN.match(name) or name in workspace.ambiguous or launch.is_known_package(name):
        return
    if may_fail(command.start.ros.command, name) or robot.dependencies.is_fetched(name):
        return
    meant = launch.package_like(robot.launch, name)
    beside = None if meant is not None else _beside(robot, command)
    if meant is None and beside is None:
        return
    place = meant.place if meant is not None else beside
    yield finding(
        name,
        f"No package '{name}' is in the tree: {effect}",
        advice=f"launch it from {meant.name}" if meant is not None else "add the package, or remove the service",
        related=[note(place, "the package of the tree" if meant else "launched from the same image")] if place else [],
        severity="warning",
        confidence="medium",
    )


def _beside(robot: Robot, command: Launching) -> Located | None:
    """Another package of the family that a service with the same image launches."""
    family = f"{command.package}".partition("_")[0] + "_"
    if sum(name.startswith(family) for name in robot.launch.workspace.packages) < FAMILY:
        return None
    return next((name for name in _of_same_image(robot, command) if name.startswith(family)), None)


def _of_same_image(robot: Robot, command: Launching) -> list[Located]:
    """The packages of the tree whose launch files services with the image of a command launch."""
    image = _image(command)
    others = [each for each in robot.runners.launches if image is not None and _image(each) == image]
    return [each.package for each in others if each.file is not None and each.package is not None]


def _image(command: Launching) -> Located | None:
    return command.runner.service.image if command.runner.service is not None else None


def _is_renamed(package: Package, name: str) -> bool:
    """Whether the build installs a launch file under this name, which has another one in the source."""
    places = (f"share/{package.name}/{folder}{name}" for folder in ("launch/", ""))
    return any(os.path.basename(origin) != name for place in places for origin in package.origins(place))
