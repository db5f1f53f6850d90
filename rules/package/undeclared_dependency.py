"""A package needs another one that its package.xml does not declare.

## What it finds
What a package needs, and what neither its package.xml nor that of a package of the workspace on which it depends
declares, in one finding for each package. It needs

- the packages that its installed launch files start or include, or whose share folder they look up, without an
  argument, and xacro where a launch file runs it;
- the packages that its installed robot descriptions look up;
- the modules that its installed nodes and launch files import at their top, where they are packages of ROS or rosdep
  has a key for them;
- the packages and libraries that its CMakeLists.txt finds with REQUIRED under no condition but `if(BUILD_TESTING)`,
  where they are packages of ROS or rosdep has a key for them. Build tools come with any that is declared. One that
  CMake looks for and does not use is named with others only;
- the packages of ROS whose headers its nodes in C++ include under no condition;
- `rosidl_default_runtime`, where it generates interfaces;
- the packages of the hardware and the controllers that its descriptions and parameter files name, where its launch
  files start the controller manager or its spawner.

What a comment in the package.xml names is left out on purpose, unless it is a dependency that is only commented out
and launch files start, and that no list of repositories fetches. Of packages that need each other, directly or through
others, the last one is not to declare the next: colcon builds no circle. What others wrote is not looked at.

The message says what follows for the worst of them: a clean build stops at a package of the same workspace; nothing of
the tree declares or installs it; rosdep and colcon do not know of it; it is there as far as others bring it.

It is an info when all that is left out is one module that ros-base has, of a package that declares others, what
something that is declared brings (launch files bring `launch_ros`), what packages on which this one depends declare,
what launch files start by an argument alone, what C++ includes of packages outside of the workspace, or what installed
launch files of a simulator or examples start, unless it is a package of the same workspace that is none for
simulations: nothing but colcon brings it. So is what packages of simulations and tests leave out, unless the build
stops or a launch file ends, and what packages for tests, experiments and lessons do, by their path. What something that
is declared may bring by its name is named with others only.

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
from bringup_lint.api.launch import Lack
from bringup_lint.api.launch import Need
from bringup_lint.api.launch import Undeclared
from bringup_lint.api.launch import undeclared
from bringup_lint.api.ros import COMMON

REST = regex(r"[ \t]*(?:<!--[^\n<>]*-->[ \t]*)?(?=\r?\n)")
"""The end of a line that has nothing or a comment."""
DEPENDENCY = regex(r"[ \t]*<\w+_?depend\b")
SHOWN = 30
"""Places, or names, that a finding shows."""
ON_TRIAL = regex(r"(?i)(?:^|[/_-])(?:tests?|testing|experiments?|trials?|playground|sandbox|education|lessons?)[/_-]")
"""Of the path of a package.xml: nobody installs such a package on a fresh robot."""
NAMED = 3
"""Packages that a message names."""
STARTED = ("node", "include", "share", "plugin")
"""Uses that end something where the package is not there."""
ASKED = {
    "node": "{} is started here",
    "include": "a launch file of {} is included here",
    "share": "the folder of {} is looked up here",
    "description": "xacro looks up {} here",
    "program": "{} is run here",
    "module": "{} is imported here",
    "library": "CMake looks for {} here",
    "header": "a header of {} is included here",
    "plugin": "a plugin of {} is named here",
    "interfaces": "what is generated here needs {} when nodes run",
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
    advised: dict[str, set[str]] = {}
    for package in robot.launch.workspace.packages.values():
        found = (
            undeclared(robot.dependencies, robot.launch, package) if robot.dependencies.must_declare(package) else None
        )
        found = _without_cycles(robot, package, found, advised) if found is not None else None
        if found is not None:
            advised[package.name] = {str(need.name) for need in found.needs}
            yield _finding(robot, package, found)


def _without_cycles(
    robot: Robot, package: launch.Package, found: Undeclared, advised: dict[str, set[str]]
) -> Undeclared | None:
    """What is to be declared without a package that needs this one, as declared or as advised before: colcon builds no
    circle. That a build stops is said in any case."""
    if found.lack is Lack.BUILD:
        return found
    needs = [need for need in found.needs if not _leads_to(robot, str(need.name), package.name, advised)]
    return found._replace(needs=needs) if needs else None


def _leads_to(robot: Robot, start: str, end: str, advised: dict[str, set[str]]) -> bool:
    """Whether a package of the workspace needs another one, directly or through others."""
    packages = robot.launch.workspace.packages
    todo, seen = [start], {start}
    while todo:
        name = todo.pop()
        if name == end:
            return True
        own = packages.get(name)
        depends = (str(each) for _, each in own.manifest.depends) if own is not None else ()
        new = ({*depends, *advised.get(name, ())} & packages.keys()) - seen
        seen |= new
        todo += new
    return False


def _finding(robot: Robot, package: launch.Package, found: Undeclared) -> Finding:
    needs = found.needs
    command = next(filter(None, map(robot.dependencies.left_out, needs)), None)
    every = [*found.needs, *found.others]
    return finding(
        _last(package) or package.place,
        f"{package.name} needs {_names(needs)} and does not declare {_them(needs)}: {_why(robot, package, found)}",
        advice=_advice(robot, package, needs),
        related=[
            *([note(command, "built without it here")] if command else ()),
            *_places(robot, every),
            *([note(_first(package), _left(package, every))] if len(every) > 1 else ()),
        ],
        fix=dependency(package, every),
        confidence="high" if found.lack is Lack.BUILD else None,
        severity=None if found.is_plain and _is_certain(robot, package, found) else "info",
    )


def _is_certain(robot: Robot, package: launch.Package, found: Undeclared) -> bool:
    """Whether the robot lacks something, the build of the workspace stops, or a launch file ends."""
    if found.lack is Lack.BUILD:
        return True
    is_needed = _ends(found) or robot.dependencies.is_for_robot(package)
    path = package.manifest.source.name
    return is_needed and not ON_TRIAL.search(path if not path.startswith("/") else f"{package.name}/")


def _ends(found: Undeclared) -> bool:
    """Whether something does not start where only what is declared is installed."""
    return found.lack is Lack.NOWHERE or (found.lack is Lack.PACKAGE and found.needs[0].use in STARTED)


def _names(needs: list[Need]) -> str:
    names = [str(need.name) for need in needs]
    left = len(names) - NAMED
    if left > 1:
        return f"{', '.join(names[:NAMED])} and {left} others"
    return " and ".join([", ".join(names[:-1]), names[-1]]) if len(names) > 1 else names[0]


def _them(needs: list[Need]) -> str:
    return "them" if len(needs) > 1 else "it"


def _why(robot: Robot, package: launch.Package, found: Undeclared) -> str:
    needs = found.needs
    first = needs[0]
    unknown = f"neither rosdep nor colcon build --packages-up-to {package.name} knows of {_them(needs)}"
    if found.lack is Lack.BUILD:
        return (
            f"a clean colcon build stops at find_package({first.name}), because its environment has only the packages "
            "that package.xml declares"
        )
    if found.lack is Lack.NOWHERE:
        how = (
            "rosdep does not install" if robot.dependencies.uses_rosdep else "nothing of this tree declares or installs"
        )
        return f"{how} {first.name}, and on a freshly installed robot {_end(first)}"
    if _ends(found):
        return f"{unknown}, and where {first.name} is not there {_end(first)}"
    if found.lack in (Lack.BASE, Lack.BROUGHT):
        is_there = "they are" if len(needs) > 1 else "it is"
        return f"{unknown}, and {is_there} there only as far as other packages bring {_them(needs)}"
    return unknown


def _end(need: Need) -> str:
    file = need.name.span.source.basename
    if need.use == "module":
        return f"{file} ends with \"No module named '{need.name}'\""
    if need.use == "program":
        return f"{file} ends, because there is no program '{need.name}'"
    if need.use == "plugin":
        return f"the controller manager does not find the plugin that {file} names"
    if need.is_process:
        return f"the command of {file} ends with \"Package '{need.name}' not found\", and launch goes on without it"
    if need.is_component:
        return f"the container of {file} does not load the component of {need.name}, and launch goes on without it"
    if need.use == "library":
        return f"the build stops at find_package({need.name})"
    return f"{file} ends with \"package '{need.name}' not found\""


def _advice(robot: Robot, package: launch.Package, needs: list[Need]) -> str:
    declared = [(tag_of(package, need), key_of(need)) for need in needs if key_of(need)]
    if not declared:
        return f"install {needs[0].name} with the robot, for example by a requirements.txt"
    tag, key = declared[0]
    others = " and the others" if len(declared) > 1 else ""
    unheard = next((need.name for need in needs if robot.dependencies.is_unheard_of(need)), None)
    where = f", and where rosdep does not know {unheard}, its source to the workspace" if unheard is not None else ""
    return f"add <{tag}>{key}</{tag}>{others} to the package.xml of {package.name}{where}"


def _first(package: launch.Package) -> Span:
    """Where the dependencies of a package begin, or would."""
    return package.manifest.first or package.manifest.export or package.manifest.source.whole


def _left(package: launch.Package, needs: list[Need]) -> str:
    names = dict.fromkeys(key_of(need) for need in needs if key_of(need))
    return f"{package.name} does not declare {', '.join([*names][:SHOWN])}"


def _places(robot: Robot, needs: list[Need]) -> list[Related]:
    """Where each is asked for, then the other files that need it in any case."""
    uses = [robot.dependencies.places(need) for need in needs]
    places = [*(each[0] for each in uses), *(use for each in uses for use in each[1:] if use.always)]
    first = {(str(use.name), use.name.span.source): use for use in reversed(places)}
    shown = [use for use in places if first[str(use.name), use.name.span.source] is use]
    return [note(use.name, ASKED[use.use].format(use.name)) for use in shown[:SHOWN]]


def _last(package: launch.Package) -> Span | None:
    """The dependency below which another one is written: the last of its kind."""
    places = package.manifest.places
    return next((places[tag] for tag in (*AT_RUN_TIME, *places) if tag in places), None)


def key_of(need: Need) -> str:
    """What the package.xml declares; empty when rosdep knows no key."""
    return need.fact.declared if need.fact else COMMON.get(str(need.name), str(need.name))


def tag_of(package: launch.Package, need: Need) -> str:
    if need.use not in ("library", "header"):
        return package.manifest.tag_at_runtime
    if need.of_tests:
        return "test_depend"
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
