"""A package needs another one that its package.xml does not declare.

## What it finds
Packages that launch files start or include or whose share folder they look up, that xacro looks up, that nodes and
launch files import at their top or that CMake finds with REQUIRED, and xacro where a launch file runs it, if neither
the package.xml nor that of a package of the workspace on which it depends declares them. A dependency that is commented
out is not declared. It is a warning

- when CMake finds a package of the same workspace;
- when ros-base lacks the package, module or library, and no package.xml, script, image, list of repositories or
  command of the documentation installs it or something that brings it. A link, a sentence or `install_requires` of a
  setup.py installs nothing; the name of a Debian package of ROS counts wherever it is written;
- when launch files start another package of the same workspace, and a script or an image builds the one that needs it
  with `--packages-up-to`, without the other;
- when the same is so, and the changelog of the package shows that it is released, which makes a Debian package of it
  alone;
- when the package.xml declares nothing that is needed at run time, and launch files start three packages or more, or
  these and the nodes need three or more, of which ros-base lacks one. Viewers and simulators do not count;
- when launch files always start five packages or more that are not declared, or three that are more than half of all
  that they start. Those of ros-base, viewers and simulators do not count;
- when nodes import or CMake requires five packages of ROS or more that are not declared, and fewer are declared. Those
  of launch files and of builds do not count;
- once a robot, for all its other packages: when sources need packages of ROS, or launch files always start packages of
  the workspace or released ones or look packages up, and neither the package.xml declares them nor what it declares
  brings them, and no comment in it says why. One is
  enough if CMake requires it or it is a package of the same workspace, else two. The finding names with them what is
  brought by others, and modules and libraries that rosdep has a key for.

Other packages of which launch files start nodes or include files are an info. Nothing is said of other modules and
libraries.

## Why it matters on a robot
A dependency that is missing in package.xml works on the developer's machine and fails on a fresh robot: rosdep does not
install it. A launch file aborts with "package 'slam_toolbox' not found", a node with "No module named 'serial'". colcon
builds a package in an environment of the packages that its package.xml declares: find_package of another one fails in a
clean workspace, and works where the workspace was sourced before.

## Bad
```xml
<!-- bringup.launch.py starts slam_toolbox -->
<depend>rclpy</depend>
```

## Good
```xml
<depend>rclpy</depend>
<exec_depend>slam_toolbox</exec_depend>
```

## When to ignore it
When the image installs the package by other means than rosdep, for example as a Debian package of the vendor.

## References
- REP 149, "depend", "exec_depend"
- REP 2001, "ros_base"
- colcon, "Build environment": only the install prefixes of declared dependencies are sourced
- colcon, "Package selection", `--packages-up-to`
"""

from __future__ import annotations

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Fix
from bringup_lint.api import Related
from bringup_lint.api import Robot
from bringup_lint.api import Span
from bringup_lint.api import finding
from bringup_lint.api import fix
from bringup_lint.api import launch
from bringup_lint.api import note
from bringup_lint.api import regex
from bringup_lint.api import rule
from bringup_lint.api.launch import AT_RUN_TIME
from bringup_lint.api.launch import Effect
from bringup_lint.api.launch import Need
from bringup_lint.api.launch import Undeclared
from bringup_lint.api.launch import brought_up
from bringup_lint.api.launch import effect_of
from bringup_lint.api.launch import of_robots
from bringup_lint.api.launch import rest_of
from bringup_lint.api.ros import COMMON

REST = regex(r"[ \t]*(?:<!--[^\n<>]*-->[ \t]*)?(?=\r?\n)")
"""The end of a line that has nothing or a comment."""
DEPENDENCY = regex(r"[ \t]*<\w+_?depend\b")
SHOWN = 12
"""Places, or names, that a finding shows."""
MOST = 30
"""Packages that a finding shows."""
ASKED = {
    "node": "{} is started here",
    "include": "a launch file of {} is included here",
    "share": "the folder of {} is looked up here",
    "description": "xacro looks up {} here",
    "program": "{} is run here",
    "module": "{} is imported here",
    "library": "CMake looks for {} here",
}


@rule(
    "warning",
    confidence="medium",
    fix="safe",
    symptoms=[
        "PackageNotFoundError",
        "package '*' not found, searching",
        "No module named",
        "Could not find a package configuration file provided by",
        "By not providing Find*.cmake in CMAKE_MODULE_PATH this project has asked CMake to find a package",
        "ModuleNotFoundError: No module named 'serial'",
        "ModuleNotFoundError: No module named 'cv2'",
        "ModuleNotFoundError: No module named 'smbus2'",
        "ModuleNotFoundError: No module named 'RPi'",
        "ModuleNotFoundError: No module named 'transforms3d'",
        "ModuleNotFoundError: No module named 'tf_transformations'",
    ],
)
def undeclared_dependency(robot: Robot) -> Iterator[Finding]:
    some = []
    for package in robot.launch.workspace.packages.values():
        if not robot.dependencies.judged(package):
            continue
        found = effect_of(robot.dependencies, robot.launch, package)
        if found is not None and found.effect is Effect.SOME:
            some.append((package, found))
        elif found is not None:
            yield _finding(robot, package, found)
            rest = rest_of(robot.dependencies, robot.launch, package, found)
            some += [(package, rest)] if rest is not None else []
    sure = [need for _, found in some for need in found.needs]
    if len(sure) > 1 or any(need.use == "library" or robot.dependencies.is_of_workspace(need) for need in sure):
        yield _of_some(some)
    else:
        yield from (_harmless(robot, package, found.started) for package, found in some if found.started)


def _of_some(some: list[tuple[launch.Package, Undeclared]]) -> Finding:
    """One for all packages of the robot that declare most of what they need, beginning with the one that lacks most."""
    some = sorted(some, key=lambda each: (-len(each[1].needs), -len(each[1].others)))
    package, found = some[0]
    first, *more = found.needs
    tag = tag_of(package, first)
    names = f"{first.name} and {len(more)} other{'s' if len(more) > 1 else ''}" if more else str(first.name)
    them = "them" if more else "it"
    others = sum(1 for _, each in some if each.needs) - 1
    count = f"; {others} more package{'s do' if others > 1 else ' does'} the same" if others else ""
    return finding(
        _last(package) or package.place,
        f"{package.name} needs {names} and does not declare {them}: neither rosdep nor colcon build --packages-up-to "
        f"knows of it{count}",
        advice=f"add <{tag}>{first.name}</{tag}>{' and the others' if more else ''} to its package.xml",
        related=[*_places(found.needs), *(note(_first(each), _left(each, _all(what))) for each, what in some[:MOST])],
        fix=_of_all(some),
    )


def _all(found: Undeclared) -> list[Need]:
    return [*found.needs, *found.others]


def _left(package: launch.Package, needs: list[Need]) -> str:
    names = dict.fromkeys(key_of(need) for need in needs if key_of(need))
    return f"{package.name} does not declare {', '.join([*names][:SHOWN])}"


def _first(package: launch.Package) -> Span:
    """Where the dependencies of a package begin, or would."""
    return package.manifest.first or package.manifest.export or package.manifest.source.whole


def _of_all(some: list[tuple[launch.Package, Undeclared]]) -> Fix | None:
    """What is missing in each of the packages; None where one has no place for it, and would be found again."""
    fixes = [dependency(package, [*_all(found), *found.started]) for package, found in some]
    edits = [edit for each in fixes if each is not None for edit in each.edits]
    return fix("declare what is missing", *edits) if None not in fixes else None


def _finding(robot: Robot, package: launch.Package, found: Undeclared) -> Finding:
    needs, started = [*found.needs, *found.others], found.started
    match found.effect:
        case Effect.BUILD:
            return _found(package, needs, started, _of_build(found.needs), "high")
        case Effect.ROBOT:
            return _found(package, needs, started, _of_robot(robot, found.needs), None)
        case Effect.APART:
            return _left_out(robot, package, needs, started)
        case Effect.RELEASE:
            return _found(package, needs, started, _of_release(package, needs[0]), None)
        case Effect.EMPTY:
            return _found(package, needs, started, _of_nothing(package, found.needs), None)
        case Effect.SEVERAL:
            return _found(package, needs, started, _of_several(robot, package, needs), None)
        case Effect.SOURCES:
            return _found(package, needs, started, _of_sources(package, needs), None)
    return _harmless(robot, package, started)


def _of_build(needs: list[Need]) -> str:
    return (
        f"A clean colcon build stops at find_package({needs[0].name}): "
        "the build environment has only the packages that package.xml declares"
    )


def _left_out(robot: Robot, package: launch.Package, needs: list[Need], started: list[Need]) -> Finding:
    command = robot.dependencies.left_out(needs[0])
    what = " ".join(str(command).replace("\\", " ").split())
    message = f"colcon build {what} leaves {needs[0].name} out, and {_end(needs[0])}"
    related = [note(command, "built without it here")] if command else []
    return _found(package, needs, started, message, None, related)


def _of_release(package: launch.Package, need: Need) -> str:
    return f"The Debian package of {package.name} does not bring {need.name}: installed alone, {_end(need)}"


def _of_nothing(package: launch.Package, needs: list[Need]) -> str:
    first, *others = of_robots(needs)
    return (
        f"{package.name} declares nothing that it needs at run time: rosdep and colcon build --packages-up-to do not "
        f"know that it needs {first.name} and {len(others)} others"
    )


def _of_several(robot: Robot, package: launch.Package, needs: list[Need]) -> str:
    first, *others = needs
    count = len(brought_up(robot.dependencies, package))
    return (
        f"The launch files of {package.name} start {count} other packages, and it does not declare {len(needs)} of "
        f"them: rosdep and colcon build --packages-up-to leave out {first.name} and {len(others)} others"
    )


def _of_sources(package: launch.Package, needs: list[Need]) -> str:
    first, *others = needs
    return (
        f"The sources of {package.name} need {len(needs)} packages that it does not declare, more than it declares: "
        f"rosdep and colcon build --packages-up-to leave out {first.name} and {len(others)} others"
    )


def _of_robot(robot: Robot, needs: list[Need]) -> str:
    first, *others = needs
    more = "1 other" if len(others) == 1 else f"{len(others)} others"
    names = f"{first.name} and {more}" if others else str(first.name)
    how = "rosdep does not install" if robot.dependencies.uses_rosdep else "Nothing of this tree declares or installs"
    return f"{how} {names}: on a freshly installed robot {_end(first)}"


def _end(need: Need) -> str:
    file = need.name.span.source.basename
    if need.use == "module":
        return f"{file} ends with \"No module named '{need.name}'\""
    if need.use == "program":
        return f"{file} ends, because there is no program '{need.name}'"
    if need.is_component:
        return f"the container of {file} does not load the component of {need.name}, and launch goes on without it"
    if need.use == "library":
        return f"the build stops at find_package({need.name})"
    return f"{file} ends with \"package '{need.name}' not found\""


def _harmless(robot: Robot, package: launch.Package, started: list[Need]) -> Finding:
    """Packages that are there all the same: in the workspace, in ros-base or by another package."""
    first = started[0]
    tag = package.manifest.tag_at_runtime
    starts = robot.launch.workspace.packages.get(str(first.name))
    circular = starts is not None and package.name in robot.launch.workspace.required(starts)
    if circular:
        advice = f"{first.name} depends on {package.name}: start it from a launch file of {first.name}"
    else:
        advice = f"add <{tag}>{first.name}</{tag}> to the package.xml"
    own = robot.dependencies.is_of_workspace(first)
    built = f"colcon build --packages-up-to {package.name} leaves it out"
    return finding(
        _last(package) or package.place,
        f"{package.name} starts {first.name} and does not declare it: {built if own else 'rosdep does not install it'}",
        advice=advice,
        related=_places(started),
        fix=None if circular else dependency(package, started),
        severity="info",
    )


def _found(
    package: launch.Package,
    needs: list[Need],
    started: list[Need],
    message: str,
    confidence: str | None,
    related: list[Related] | None = None,
) -> Finding:
    declared = [(tag_of(package, need), key_of(need)) for need in needs if key_of(need)]
    tag, key = declared[0] if declared else ("", "")
    left = [need for need in [*needs, *started] if key_of(need)]
    all_left = [note(_first(package), _left(package, left))] if len(left) > 1 else []
    return finding(
        _last(package) or package.place,
        message,
        advice=f"add <{tag}>{key}</{tag}> to the package.xml of {package.name}"
        if key
        else f"install {needs[0].name} with the robot, for example by a requirements.txt",
        related=[*(related or ()), *_places(needs), *all_left],
        fix=dependency(package, [*needs, *started]),
        confidence=confidence,
    )


def _last(package: launch.Package) -> Span | None:
    """The dependency below which another one is written: the last of its kind."""
    places = package.manifest.places
    return next((places[tag] for tag in (*AT_RUN_TIME, *places) if tag in places), None)


def _places(needs: list[Need]) -> list[Related]:
    return [note(need.name, ASKED[need.use].format(need.name)) for need in needs[:SHOWN]]


def key_of(need: Need) -> str:
    """What the package.xml declares; empty when rosdep knows no key."""
    return need.fact.declared if need.fact else COMMON.get(str(need.name), str(need.name))


def tag_of(package: launch.Package, need: Need) -> str:
    if need.use != "library":
        return package.manifest.tag_at_runtime
    return "depend" if package.manifest.format > 1 else "build_depend"


def dependency(owner: launch.Package, needs: list[Need]) -> Fix | None:
    """More dependencies below the last of their kind, past a comment in its line."""
    last = _last(owner)
    lines = dict.fromkeys(
        f"<{tag_of(owner, need)}>{key_of(need)}</{tag_of(owner, need)}>" for need in needs if key_of(need)
    )
    if last is None or not lines:
        return None
    source = last.source
    rest = REST.match(source.text, last.end)
    end = rest.end() if rest else last.end
    above = source.line_text(last.line)
    indent = above[: len(above) - len(above.lstrip())]
    gap = "\n" if _has_heading(last) else ""
    added = "".join(f"\n{indent}{line}" for line in lines)
    return fix("declare what is missing", (source.span(end, end), f"{gap}{added}"))


def _has_heading(last: Span) -> bool:
    """Whether a comment begins the lines that a dependency is one of: it may not mean another one."""
    line = last.line - 1
    while line and DEPENDENCY.match(last.source.line_text(line)):
        line -= 1
    return line > 0 and last.source.line_text(line).rstrip().endswith("-->")
