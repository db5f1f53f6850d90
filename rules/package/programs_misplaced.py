"""The programs of a package are not where ros2 run looks, or not executable.

## What it finds
A package of the type `ament_python` whose setup.cfg does not put its console scripts into `lib/<package>`, or that has
no setup.cfg, where one of the scripts makes a node. A script in Python, with `#!` and `__main__`, that CMake installs
into `lib/<package>` with `install(FILES)`, which takes its executable mode away. Nodes in C++ that `install(TARGETS)`
puts nowhere in particular, for which CMake takes `bin`, in one finding for each package; silent where a file of the
tree starts a program from there, or gives `CMAKE_INSTALL_BINDIR` a value. What a launch file starts is left to
`launch/executable-missing`, and misspelt lines of setup.cfg are left to `package/setup-cfg-unread`.

## Why it matters on a robot
setuptools and CMake put the programs into `bin`: `ros2 run` ends with "No executable found", and so does each unit and
script that starts the node with it. `colcon build` says nothing.

## Bad
```ini
[develop]
script_dir=$base/lib/rover_arm
```

## Good
```ini
[develop]
script_dir=$base/lib/rover_arm
[install]
install_scripts=$base/lib/rover_arm
```

## When to ignore it
When the programs are meant to be started by their names alone.

## References
- https://docs.ros.org/en/jazzy/How-To-Guides/Developing-a-ROS-2-Package.html, "setup.cfg"
- ros2pkg, `get_executable_paths`: it looks into `lib/<package>` alone, for files that may be executed
- cmake install(FILES), "PERMISSIONS"
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Located
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import note
from bringup_lint.api import rule
from bringup_lint.api.launch import Package
from bringup_lint.api.launch import literal_text

SHOWN = 20
"""Programs that a finding shows."""


@rule("warning", symptoms=["No executable found"])
def programs_misplaced(robot: Robot) -> Iterator[Finding]:
    for package in robot.launch.workspace.packages.values():
        if robot.dependencies.judged(package):
            for name in robot.dependencies.programs_without_mode(package):
                yield finding(
                    name,
                    f"`ros2 run {package.name} {name}` finds no executable: install(FILES) gives it the mode 644",
                    advice="write install(PROGRAMS ...)",
                )
        if robot.dependencies.must_declare(package):
            yield from _unplaced(package, list(robot.dependencies.unplaced_programs(package)))
    yield from _of_python(robot)


def _unplaced(package: Package, nodes: list[Located]) -> Iterator[Finding]:
    for name in nodes[:1]:
        yield finding(
            name,
            f"`ros2 run {package.name} {name}` finds no executable: install() without a folder for programs takes bin",
            advice=f"write RUNTIME DESTINATION lib/{package.name}",
            related=[note(each, "nor is this one found") for each in nodes[1:SHOWN]],
        )


def _of_python(robot: Robot) -> Iterator[Finding]:
    packages = [each for each in robot.launch.workspace.packages.values() if each.manifest.build_type == "ament_python"]
    lost = [
        each for each in packages if robot.dependencies.judged(each) and any(map(each.is_misplaced, each.entry_points))
    ]
    if not lost:
        return
    started = {str(literal_text(each.package)) for each in robot.launch.nodes}
    told = {str(each.package) for each in robot.dependencies.unread_settings}
    for package in lost:
        if package.name not in started and package.name not in told:
            yield from _of_nodes(robot, package)


def _of_nodes(robot: Robot, package: Package) -> Iterator[Finding]:
    programs = ((name, robot.nodes.program(package.name, name)) for name in package.entry_points)
    nodes = [name for name, program in programs if program is not None and program.classes]
    if nodes:
        where = package.scripts_folder
        folder = str(where).removeprefix("$base/") if where else "bin"
        yield finding(
            package.executables[nodes[0]],
            f"`ros2 run {package.name} {nodes[0]}` finds no executable: the programs of {package.name} go to {folder}",
            advice=f"write 'install_scripts=$base/lib/{package.name}' in the section [install] of setup.cfg",
            related=[note(where, "here")] if where else (),
        )
