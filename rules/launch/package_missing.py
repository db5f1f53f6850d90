"""A launch file starts a node from a package that does not exist.

## What it finds
A name that no package of this workspace has, but that is close to one that exists; or whose executable one other
package of the workspace installs, where the executable is called like the missing package; or that is called like a
program of Navigation2 or another common package, or nearly like the package, and starts its program: `behavior_server`
for `nav2_behaviors`; or, wherever a launch file, a node or a robot description asks for the folder of a package or a
launch file starts one, that is a letter away from a package which a package.xml of the tree declares or which is
common: `joy_telop`; or that nothing of the tree knows, where the launch file asks for a file of it that its own package
has, too: it is a copy from another project. Also, as packages of nodes and of included files, those of ROS 1 that ROS 2
has under other names (`rviz`, `tf`, `amcl`, ...), and those that the robot's distribution no longer has
(`nav2_recoveries` from Humble on, `gazebo_ros` and `ros_ign_*` from Jazzy on). Left alone is what a list of
repositories or a command of the tree fetches, and files that ask which distribution runs. It is an info in tests that
the build of their package does not name.

## Why it matters on a robot
launch aborts with "package 'my_robot_drivers' not found".

## Bad
```python
Node(package='my_robot_drivers', executable='motor')   # the package is called my_robot_driver
```

## Good
```python
Node(package='my_robot_driver', executable='motor')
```

## When to ignore it
When both packages exist, and the other one is not in this repository, or when the robot builds the old one from its
source.

## References
- ament_index, `get_package_prefix`
- https://github.com/ros/rosdistro: the packages of each distribution
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Located
from bringup_lint.api import Related
from bringup_lint.api import Robot
from bringup_lint.api import Span
from bringup_lint.api import finding
from bringup_lint.api import fix
from bringup_lint.api import launch
from bringup_lint.api import note
from bringup_lint.api import rule

SHORTEST = 6
"""Characters of a name that an executable has in its own by no accident."""


@rule(
    "error", fix="unsafe", symptoms=["PackageNotFoundError", "not found, searching", "package '*' not found, searching"]
)
def package_missing(robot: Robot) -> Iterator[Finding]:
    yield from _gone(robot)
    said = set()
    for each in _of_nodes(robot):
        said.add(each.span)
        yield each
    yield from _copied(robot, said)
    yield from _a_letter_away(robot, said)


def _copied(robot: Robot, said: set[Span]) -> Iterator[Finding]:
    """Launch files of another project, which still ask for files of its package."""
    for each in launch.copied_packages(robot.launch, robot.dependencies.is_fetched):
        said.add(each.name.span)
        yield finding(
            each.name,
            f"Nothing of this tree knows a package '{each.name}', and {each.path} is in {each.owner.name}: without "
            "that package launch aborts",
            advice=f"write {each.owner.name}",
            chain=robot.provenance.chain_to(each.name, f"'{each.name}' is needed"),
            related=[note(each.owner.place, "the package of this launch file")],
            severity="warning",
            confidence="medium",
        )


def _of_nodes(robot: Robot) -> Iterator[Finding]:
    workspace = robot.launch.workspace
    for node in robot.launch.nodes:
        package = launch.literal_text(node.package)
        owner = workspace.owner(node.file.source)
        if package is None or owner is None or package == owner.name or owner.depends_on(package):
            continue
        near = launch.package_like(robot.launch, package)
        if near is not None:
            yield finding(
                package,
                f"Package '{package}' not found: launch aborts",
                advice=f"start it from '{near.name}'",
                chain=robot.provenance.chain_to_node(node),
                related=[note(near.place, "the package of the workspace")],
                fix=fix(f"write {near.name}", (package, near.name), safe=False)
                if package.span.text == package
                else None,
            )
        else:
            yield from _moved(robot, node, package)


def _a_letter_away(robot: Robot, said: set[Span]) -> Iterator[Finding]:
    for each in robot.dependencies.misspelt_packages:
        if each.name.span in said:
            continue
        effect = "launch aborts" if each.is_launch else "what asks for its folder ends"
        yield finding(
            each.name,
            f"No package '{each.name}' is here or known: {effect}",
            advice=f"write {each.meant}",
            chain=robot.provenance.chain_to(each.name, f"'{each.name}' is needed"),
            related=[note(each.place, "the package that is meant")] if each.place is not None else [],
            fix=fix(f"write {each.meant}", (each.name, each.meant), safe=False),
        )


def _gone(robot: Robot) -> Iterator[Finding]:
    """Packages of ROS 1, and of older distributions."""
    for each in launch.gone_packages(robot.launch):
        fetched = any(map(robot.dependencies.is_fetched, filter(None, (each.name, each.package.repository))))
        if fetched or launch.package_like(robot.launch, each.name) is not None:
            continue
        why = f"{each.distro.capitalize()} no longer has it" if each.distro else "ROS 2 does not have it"
        yield finding(
            each.name,
            f"Package '{each.name}' not found: {why}, and launch aborts",
            advice=f"use {each.package.instead}",
            chain=robot.provenance.chain_to(each.name, f"'{each.name}' is needed"),
            severity=_grade(robot, each.name, each.always),
        )


def _grade(robot: Robot, name: Located, always: bool) -> str | None:
    if robot.launch.is_unrun_test(name.span.source):
        return "info"
    return None if always else "warning"


def _moved(robot: Robot, node: launch.Started, package: Located) -> Iterator[Finding]:
    """A package that became a part of another one, which installs its executable now; or one that never was."""
    executable = launch.literal_text(node.executable)
    workspace = robot.launch.workspace
    known = package in workspace.packages or package in workspace.ambiguous or launch.is_known_package(package)
    if known or executable is None or robot.dependencies.is_fetched(package):
        return
    public = launch.package_meant(package, executable)
    if public is not None:
        yield _renamed(robot, node, package, public)
        return
    if len(package) < SHORTEST or package not in executable:
        return
    having = [each for each in workspace.packages.values() if executable in each.executables]
    if len(having) == 1:
        yield _renamed(
            robot, node, package, having[0].name, note(having[0].executables[executable], "what installs it")
        )


def _renamed(robot: Robot, node: launch.Started, package: Located, other: str, *related: Related) -> Finding:
    executable = launch.literal_text(node.executable)
    return finding(
        package,
        f"No package '{package}' is here or known, and {other} installs '{executable}': launch aborts",
        advice=f"start it from '{other}'",
        chain=robot.provenance.chain_to_node(node),
        related=related,
        fix=fix(f"write {other}", (package, other), safe=False) if package.span.text == package else None,
        severity="warning",
        confidence="medium",
    )
