"""A launch file starts an executable that its package does not have.

## What it finds
Executables of workspace packages that neither setup.py (`console_scripts`) nor CMakeLists.txt (`install`, component
registration) provides, console scripts that setup.cfg does not put into `lib/<package>`, and scripts that
`install(FILES)` installs without their executable bit. Of common public packages (Navigation2, robot_localization,
slam_toolbox, controller_manager, joy, teleop_twist_joy, tf2_ros, ...): executables that no distribution has, and those
that have another name in the robot's distribution, as `spawner.py` from Humble on. A node that does not start by
default is a warning.

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

from __future__ import annotations

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Fix
from bringup_lint.api import Located
from bringup_lint.api import Related
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import fix
from bringup_lint.api import launch
from bringup_lint.api import note
from bringup_lint.api import regex
from bringup_lint.api import rule
from bringup_lint.api.spelling import nearest

Start = tuple[launch.Started, Located]
"""A node, and the name of its executable."""
SYMLINKS = regex(r"--symlink-install\b")
"""With links in the place of files, a script keeps the mode that it has in the source."""


@rule("error", fix="unsafe", symptoms=["not found on the libexec directory"])
def executable_missing(robot: Robot) -> Iterator[Finding]:
    elsewhere: dict[str, list[Start]] = {}
    made: dict[str, list[Start]] = {}
    for node in robot.launch.nodes:
        name, executable = launch.literal_text(node.package), launch.literal_text(node.executable)
        if name is None or executable is None:
            continue
        package = robot.launch.workspace.packages.get(name)
        if package is not None:
            yield from of_workspace(robot, node, package, executable)
            if executable in package.executables and package.is_misplaced(executable):
                elsewhere.setdefault(name, []).append((node, executable))
            elif package.made(executable) and robot.launch.workspace.lacks(package, executable):
                made.setdefault(name, []).append((node, executable))
        elif name not in robot.launch.workspace.ambiguous and node.file.source.judged:
            yield from of_public(robot, node, name, executable)
    packages = robot.launch.workspace.packages
    yield from (misplaced(robot, packages[package], started) for package, started in elsewhere.items())
    yield from (only_made(robot, packages[package], started) for package, started in made.items())


def of_workspace(robot: Robot, node: launch.Started, package: launch.Package, executable: Located) -> Iterator[Finding]:
    if robot.launch.workspace.lacks(package, executable) and not package.made(executable):
        yield missing(robot, node, package, executable)
    elif executable in package.without_mode and package.installs_known:
        yield without_mode(robot, node, package, executable)


def of_public(robot: Robot, node: launch.Started, name: str, executable: Located) -> Iterator[Finding]:
    """Programs that no release of a public package has, or that it has under another name now."""
    package = launch.public_package(name)
    if package is None or robot.dependencies.is_forked(name) or robot.launch.looks_at_distribution(node.file):
        return
    distro = robot.launch.distribution(node.file)
    if package.is_gone(distro):
        return
    now = package.renamed(executable, distro)
    if now is not None:
        yield finding(
            executable,
            f"{name} has no executable '{executable}' after {now.last.capitalize()}: launch aborts",
            advice=f"start '{now.now}'",
            chain=robot.provenance.chain_to_node(node),
            fix=_fix(executable, now.now),
            severity=_severity(node),
        )
    elif package.lacks(executable):
        names = [each.name for each in package.programs if not each.last]
        near = nearest(executable, names, 3)
        yield finding(
            executable,
            f"{name} has no executable '{executable}': launch aborts",
            advice=f"start {' or '.join(near or names)}",
            chain=robot.provenance.chain_to_node(node),
            fix=_fix(executable, near[0]) if len(near) == 1 else None,
            severity=_severity(node),
        )


def misplaced(robot: Robot, package: launch.Package, started: list[Start]) -> Finding:
    """Console scripts where launch does not look: in ``bin``, or in the folder of another package."""
    (node, executable), *others = started
    folder = package.scripts_folder
    place = folder or package.executables[executable]
    where = str(folder).removeprefix("$base/") if folder else "bin"
    return finding(
        executable,
        f"'{executable}' is not installed in lib/{package.name}: launch aborts",
        advice=f"write 'install_scripts=$base/lib/{package.name}' in the section [install] of setup.cfg",
        chain=robot.provenance.chain_to_node(node),
        related=[note(place, f"the console scripts go to {where}"), *_others(others)],
        severity=_severity_of(started),
    )


def only_made(robot: Robot, package: launch.Package, started: list[Start]) -> Finding:
    """Programs that CMake builds, and installs not at all or elsewhere."""
    (node, executable), *others = started
    made = package.made(executable)
    related = [note(made.target, "built here")] if made else []
    if made and made.elsewhere:
        related.append(note(made.elsewhere, f"installed here, and not into lib/{package.name}"))
    elif made and made.others:
        related.append(note(made.others, f"installed into lib/{package.name} is this, without {executable}"))
    return finding(
        executable,
        f"'{executable}' is built and not installed in lib/{package.name}: launch aborts",
        advice=f"add it to install(TARGETS ... DESTINATION lib/{package.name})",
        chain=robot.provenance.chain_to_node(node),
        related=[*related, *_others(others)],
        severity=_severity_of(started),
    )


def _others(started: list[Start]) -> list[Related]:
    return [note(other, f"'{other}' is not found either") for _, other in started]


def _severity_of(started: list[Start]) -> str | None:
    return "warning" if all(_severity(each) for each, _ in started) else None


def without_mode(robot: Robot, node: launch.Started, package: launch.Package, executable: Located) -> Finding:
    """A script that CMake installs as a plain file, which nobody may run."""
    linked = robot.files.mentions(SYMLINKS)
    return finding(
        executable,
        f"'{executable}' is installed without its executable bit: launch does not find it, and aborts",
        advice="install it with install(PROGRAMS ...)",
        chain=robot.provenance.chain_to_node(node),
        related=[note(package.without_mode[executable], "install(FILES) gives it the mode 644")],
        severity="info" if linked else _severity(node),
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
