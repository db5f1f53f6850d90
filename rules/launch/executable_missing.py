"""A launch file starts an executable that its package does not have.

## What it finds
Executables of workspace packages that neither setup.py (`console_scripts`) nor CMakeLists.txt (`install`, component
registration) provides, and console scripts that setup.cfg does not put into `lib/<package>`. For gazebo_ros: every
executable except `spawn_entity.py`; from Humble on also `spawner.py` of controller_manager. A node that
does not start by default is a warning.

## Why it matters on a robot
launch aborts with "executable 'x' not found on the libexec directory": no node of the whole launch file starts.

## Bad
```python
Node(package='my_robot', executable='controler_node')   # setup.py: 'controller_node = my_robot.controller:main'
```

## Good
```python
Node(package='my_robot', executable='controller_node')
```

## When to ignore it
When the build installs the executable by a means that CMakeLists.txt does not show, such as a script that an
external project generates.

## References
- launch_ros, `ExecutableInPackage`
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Fix
from bringup_lint.api import Located
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import fix
from bringup_lint.api import launch
from bringup_lint.api import note
from bringup_lint.api import rule
from bringup_lint.api.spelling import nearest

PUBLIC = {"gazebo_ros": ("spawn_entity.py",)}
"""All executables of public packages whose names are often guessed wrong."""
RENAMED = {("controller_manager", "spawner.py"): "spawner", ("controller_manager", "unspawner.py"): "unspawner"}
"""Executables of public packages that Humble has no more under their old names (ros2_control, setup.cfg)."""
BEFORE = (None, "foxy", "galactic")


@rule("error", fix="unsafe", symptoms=["not found on the libexec directory"])
def executable_missing(robot: Robot) -> Iterator[Finding]:
    for node in robot.launch.nodes:
        name, executable = launch.literal_text(node.package), launch.literal_text(node.executable)
        if name is None or executable is None:
            continue
        package = robot.launch.workspace.packages.get(name)
        if package is not None:
            yield from of_workspace(robot, node, package, executable)
        elif name in PUBLIC and executable not in PUBLIC[name]:
            yield unknown(node, name, executable)
        elif (name, executable) in RENAMED and robot.target.ros not in BEFORE and node.file.source.judged:
            yield renamed(robot, node, name, executable)


def of_workspace(robot: Robot, node: launch.Started, package: launch.Package, executable: Located) -> Iterator[Finding]:
    if executable in package.executables and package.is_misplaced(executable):
        yield misplaced(robot, node, package, executable)
    if robot.launch.workspace.lacks(package, executable):
        yield missing(robot, node, package, executable)


def unknown(node: launch.Started, package: str, executable: Located) -> Finding:
    return finding(
        executable,
        f"{package} has no executable '{executable}': launch aborts",
        advice="include one of the package's launch files instead",
        severity=_severity(node),
    )


def renamed(robot: Robot, node: launch.Started, package: str, executable: Located) -> Finding:
    now = RENAMED[package, executable]
    return finding(
        executable,
        f"{package} has no executable '{executable}' since Humble: launch aborts",
        advice=f"start '{now}'",
        chain=robot.provenance.chain_to_node(node),
        fix=_fix(executable, now),
        severity=_severity(node),
    )


def misplaced(robot: Robot, node: launch.Started, package: launch.Package, executable: Located) -> Finding:
    """A console script in ``bin``, where launch does not look."""
    return finding(
        executable,
        f"'{executable}' is not installed in lib/{package.name}: launch aborts",
        advice=f"write 'install_scripts=$base/lib/{package.name}' in the section [install] of setup.cfg",
        chain=robot.provenance.chain_to_node(node),
        related=[note(package.executables[executable], "the console script, which goes to bin")],
        severity=_severity(node),
    )


def missing(robot: Robot, node: launch.Started, package: launch.Package, executable: Located) -> Finding:
    near = nearest(executable, sorted(package.executables), 3)
    builds = [build.source for build in package.builds[:1]]
    related = [note(package.executables[near[0]], "the executable of the package")] if near else []
    return finding(
        executable,
        f"{package.name} has no executable '{executable}': launch aborts",
        advice=f"start '{near[0]}'" if near else f"install it in {builds[0].name if builds else package.name}",
        chain=robot.provenance.chain_to_node(node),
        related=related or [note(build, "what the package installs") for build in builds],
        fix=_fix(executable, near[0]) if len(near) == 1 else None,
        severity=_severity(node),
    )


def _fix(executable: Located, name: str) -> Fix | None:
    is_written = executable.span.text == executable
    return fix(f"write {name}", (executable, name), safe=False) if is_written else None


def _severity(node: launch.Started) -> str | None:
    return "warning" if node.by_default is not True else None
