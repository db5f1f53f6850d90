"""A launch file or command starts an executable that its package does not have.

## What it finds
Executables of workspace packages that neither setup.py (`console_scripts`) nor CMakeLists.txt (`install`, component
registration) provides, console scripts that setup.cfg does not put into `lib/<package>`, and scripts that
`install(FILES)` installs without their executable bit. Of common public packages (Navigation2, robot_localization,
slam_toolbox, controller_manager, joy, teleop_twist_joy, tf2_ros, ...): executables that no distribution has, and those
that have another name in the robot's distribution, as `spawner.py` from Humble on. A node that does not start by
default is a warning; a program that is commented out in CMake is an info where nothing includes the launch file, and so
is a console script that `colcon build --symlink-install` puts in its place, where nothing builds without.

`ros2 run` in units, scripts, containers and other files that start processes is checked in the same way, also where a
script hands it to tmux, a terminal window or an alias; in a script that only people start, it is a warning. Not
reported: commands whose failure is expected (`||`, `2>/dev/null`), and those of scripts that test what there is.

## Why it matters on a robot
launch aborts with "executable 'x' not found on the libexec directory": no node of the whole launch file starts.
`ros2 run` ends with "No executable found". `install(PROGRAMS driver.py)` keeps the ending: its name is `driver.py`.

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
- launch_ros, `ExecutableInPackage`; ros2run, `get_executable_path`
"""

from __future__ import annotations

from collections.abc import Callable
from collections.abc import Iterable
from collections.abc import Iterator
from functools import partial

from bringup_lint.api import Finding
from bringup_lint.api import Fix
from bringup_lint.api import Located
from bringup_lint.api import NamedTuple
from bringup_lint.api import Related
from bringup_lint.api import Robot
from bringup_lint.api import Source
from bringup_lint.api import Span
from bringup_lint.api import finding
from bringup_lint.api import fix
from bringup_lint.api import launch
from bringup_lint.api import note
from bringup_lint.api import regex
from bringup_lint.api import rule
from bringup_lint.api.shell import may_fail
from bringup_lint.api.spelling import longer
from bringup_lint.api.spelling import nearest_of_few

SYMLINKS = regex(r"--symlink-install\b")
"""With links in the place of files, a script keeps the mode that it has in the source."""
UNKNOWN = regex(r"[$`%*{\\^]")
"""What a shell, systemd or a template fills in."""
PUT_AWAY = regex(r"(?m)^[ \t]*#[^\n]{0,80}\b(?:add_executable|ament_add_gtest)[ \t]*\([ \t]*([\w.-]+)")
_DEVELOP = regex(r"(?m)^script[_-]dir[ \t]*=[ \t]*\$base/(?P<place>[^\s]+)$")
"""The line of setup.cfg that ``colcon build --symlink-install`` reads."""
_ADDED = regex(r"(?i)(?:[_-]?(?:node|exe|main|app)){1,3}$|\.py$")
"""What is added to the name of a program."""
MANY = 300
"""Executables of a package among which none is looked for that a misspelt one means."""

ABORTS = "launch aborts"
ENDS = "ros2 run ends with 'No executable found'"


class Start(NamedTuple):
    """A node of a launch file or a command, and the executable that it starts."""

    package: str
    executable: Located
    chain: Callable[[], Iterable[Related]]
    effect: str = ABORTS
    severity: str | None = None
    distro: str | None = None
    judged: bool = True
    """What public packages have is asked, too: the file is judged, and does not ask itself which distribution runs."""
    is_left: bool = False
    """Nothing of the tree includes the launch file."""
    node: Span | None = None
    """The action of the launch file."""

    @property
    def used(self) -> list[Related]:
        """The action, where the name of the executable stands elsewhere."""
        if self.node is None or self.node.holds(self.executable.span):
            return []
        return [note(self.node, "started here")]


@rule(
    "error",
    fix="unsafe",
    symptoms=[
        "not found on the libexec directory",
        "found at '*', but libexec directory '*' does not exist",
        "No executable found",
    ],
)
def executable_missing(robot: Robot) -> Iterator[Finding]:
    elsewhere: dict[str, list[Start]] = {}
    made: dict[str, list[Start]] = {}
    for start in (*_of_launch_files(robot), *_of_commands(robot)):
        workspace = robot.launch.workspace
        name, executable = start.package, start.executable
        package = workspace.packages.get(name)
        if package is not None:
            yield from of_workspace(robot, start, package)
            if executable in package.executables and package.is_misplaced(executable):
                elsewhere.setdefault(name, []).append(start)
            elif package.made(executable) and workspace.lacks(package, executable):
                made.setdefault(name, []).append(start)
        elif name not in workspace.ambiguous and start.judged:
            yield from of_public(robot, start)
    yield from (misplaced(robot, robot.launch.workspace.packages[name], started) for name, started in elsewhere.items())
    yield from (only_made(robot.launch.workspace.packages[name], started) for name, started in made.items())


def _of_launch_files(robot: Robot) -> Iterator[Start]:
    if not robot.has_launch_files:
        return
    judged = set(robot.launch.judged)
    for node in robot.launch.nodes:
        package, executable = launch.literal_text(node.package), launch.literal_text(node.executable)
        if package is not None and executable is not None:
            yield Start(
                str(package),
                executable,
                partial(robot.provenance.chain_to_node, node),
                severity="warning" if node.by_default is not True else None,
                distro=launch.distribution_of(robot.launch, node.file),
                judged=node.file in judged and not launch.looks_at_distribution(node.file),
                is_left=id(node.file) not in robot.launch.included,
                node=node.span,
            )


def _of_commands(robot: Robot) -> Iterator[Start]:
    """Each ``ros2 run`` that is surely meant to work, once, whoever runs its script."""
    found: dict[Span, Start] = {}
    for runner, ros in robot.runners.run:
        if not runner.certain or runner.purpose.value in ("test", "archive"):
            continue
        if ros.package is None or ros.target is None or ros.target.span in found or UNKNOWN.search(ros.target):
            continue
        if may_fail(ros.command, ros.target):
            continue
        severity = None if robot.runners.is_supervised(runner) else "warning"
        chain = partial(robot.provenance.chain_to, ros.target, f"'{ros.target}' is run")
        found.setdefault(ros.target.span, Start(str(ros.package), ros.target, chain, ENDS, severity))
    yield from found.values()


def of_workspace(robot: Robot, start: Start, package: launch.Package) -> Iterator[Finding]:
    executable = start.executable
    if robot.launch.workspace.lacks(package, executable) and not package.made(executable):
        homes = [each for each in robot.launch.workspace.packages.values() if executable in each.executables]
        yield of_other_package(start, package, homes[0]) if len(homes) == 1 else missing(start, package)
    elif executable in package.without_mode and package.installs_known:
        yield without_mode(robot, start, package)


def of_public(robot: Robot, start: Start) -> Iterator[Finding]:
    """Programs that no release of a public package has, or that it has under another name now."""
    name, executable, distro = start.package, start.executable, start.distro
    package = launch.public_package(name)
    if package is None or robot.dependencies.is_forked(name) or package.is_gone(distro):
        return
    now = package.renamed(executable, distro)
    if now is not None:
        yield finding(
            executable,
            f"{name} has no executable '{executable}' after {now.last.capitalize()}: {start.effect}",
            advice=f"start '{now.now}'",
            chain=start.chain(),
            related=start.used,
            fix=_fix(executable, now.now),
            severity=start.severity,
        )
    elif package.lacks(executable):
        names = [each.name for each in package.programs if not each.last]
        near = nearest_of_few(executable, names, 3)
        yield finding(
            executable,
            f"{name} has no executable '{executable}': {start.effect}",
            advice=f"start {' or '.join(near or names)}",
            chain=start.chain(),
            related=start.used,
            fix=_fix(executable, near[0]) if len(near) == 1 else None,
            severity=start.severity,
        )


def misplaced(robot: Robot, package: launch.Package, started: list[Start]) -> Finding:
    """Console scripts where launch does not look: in ``bin``, or in the folder of another package. A build with links
    asks another section."""
    start, *others = started
    executable = start.executable
    folder = package.scripts_folder
    place = folder or package.executables[executable]
    where = str(folder).removeprefix("$base/") if folder else "bin"
    return finding(
        executable,
        f"'{executable}' is not installed in lib/{package.name}: {start.effect}",
        advice=f"write 'install_scripts=$base/lib/{package.name}' in the section [install] of setup.cfg",
        chain=start.chain(),
        related=[*start.used, note(place, f"the console scripts go to {where}"), *_others(others)],
        severity="info" if is_linked(robot, package) else _severity_of(started),
    )


def is_linked(robot: Robot, package: launch.Package) -> bool:
    """Whether the tree builds a package with links only, and setup.cfg has the right folder for these."""
    places = (each["place"] for build in package.builds for each in _DEVELOP.finditer(build.source.text))
    return any(place == f"lib/{package.name}" for place in places) and robot.dependencies.leads_to_source(package)


def only_made(package: launch.Package, started: list[Start]) -> Finding:
    """Programs that CMake builds, and installs not at all or elsewhere."""
    start, *others = started
    executable = start.executable
    made = package.made(executable)
    related = [note(made.target, "built here")] if made else []
    if made and made.elsewhere:
        related.append(note(made.elsewhere, f"installed here, and not into lib/{package.name}"))
    elif made and made.others:
        related.append(note(made.others, f"installed into lib/{package.name} is this, without {executable}"))
    return finding(
        executable,
        f"'{executable}' is built and not installed in lib/{package.name}: {start.effect}",
        advice=f"add it to install(TARGETS ... DESTINATION lib/{package.name})",
        chain=start.chain(),
        related=[*start.used, *related, *_others(others)],
        severity=_severity_of(started),
    )


def _others(started: list[Start]) -> list[Related]:
    return [note(other.executable, f"'{other.executable}' is not found either") for other in started]


def _severity_of(started: list[Start]) -> str | None:
    return "warning" if all(each.severity for each in started) else None


def without_mode(robot: Robot, start: Start, package: launch.Package) -> Finding:
    """A script that CMake installs as a plain file, which nobody may run."""
    executable = start.executable
    linked = robot.files.mentions(SYMLINKS)
    return finding(
        executable,
        f"'{executable}' is installed without its executable bit: {start.effect}",
        advice="install it with install(PROGRAMS ...)",
        chain=start.chain(),
        related=[note(package.without_mode[executable], "install(FILES) gives it the mode 644")],
        severity="info" if linked else start.severity,
    )


def of_other_package(start: Start, package: launch.Package, home: launch.Package) -> Finding:
    """An executable that another package of the workspace has."""
    executable = start.executable
    return finding(
        executable,
        f"{package.name} has no executable '{executable}': {start.effect}",
        advice=f"start it from the package {home.name}",
        chain=start.chain(),
        related=[*start.used, note(home.executables[executable], f"the executable of {home.name}")],
        severity=start.severity,
    )


def missing(start: Start, package: launch.Package) -> Finding:
    executable = start.executable
    few = package.executables if len(package.executables) <= MANY else ()
    fuller = longer(executable, few)
    alike = [each for each in few if bare_name(each) == bare_name(executable)]
    sure = fuller if len(fuller) == 1 else alike
    near = sure if len(sure) == 1 else nearest_of_few(executable, package.executables, 3)
    builds = [build.source for build in package.builds[:1]]
    related = [note(package.executables[near[0]], "the executable of the package")] if near else []
    return finding(
        executable,
        f"{package.name} has no executable '{executable}': {start.effect}",
        advice=f"start '{near[0]}'" if near else f"install it in {builds[0].name if builds else package.name}",
        chain=start.chain(),
        related=start.used + (related or [note(build, "what the package installs") for build in builds]),
        fix=_fix(executable, near[0]) if len(near) == 1 else None,
        severity="info" if start.is_left and _is_commented_out(package, executable) else start.severity,
    )


def bare_name(executable: str) -> str:
    """The name of a program without what people add to it, and take away again."""
    return _ADDED.sub("", executable).lower().replace("-", "_")


def _is_commented_out(package: launch.Package, executable: str) -> bool:
    """Whether the line of a CMakeLists.txt that would build it is a comment."""
    sources = (build.source for build in package.builds)
    return any(executable in each.once(PUT_AWAY, partial(_put_away, each)) for each in sources)


def _put_away(build: Source) -> frozenset[str]:
    return frozenset(PUT_AWAY.findall(build.text))


def _fix(executable: Located, name: str) -> Fix | None:
    is_written = executable.span.text == executable
    return fix(f"write {name}", (executable, name), safe=False) if is_written else None
