"""A launch file starts a node from a package that will be missing.

## What it finds
Two kinds of packages. A name that no package of this workspace has, but that is close to one that exists, is an
error. A package on which the launching package does not depend is info; it is a warning when it is a public package
that is started without any argument, a script or Dockerfile of the tree runs `rosdep install`, and no package.xml,
script, image, list of repositories or documentation names the package.

## Why it matters on a robot
launch aborts with "package 'my_robot_drivers' not found". A dependency that is missing in package.xml works on the
developer's machine and fails on a fresh robot: rosdep does not install it, and `colcon build --packages-up-to` does not
build a package of the workspace.

## Bad
```python
Node(package='my_robot_drivers', executable='motor')   # the package is called my_robot_driver
```

## Good
```python
Node(package='my_robot_driver', executable='motor')
```

## When to ignore it
When the image installs the package by other means than rosdep, for example as a Debian package of the vendor.

## References
- REP 149, "exec_depend"
- ament_index, `get_package_prefix`
"""

import os
import re
from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Fix
from bringup_lint.api import Located
from bringup_lint.api import Robot
from bringup_lint.api import Source
from bringup_lint.api import Span
from bringup_lint.api import finding
from bringup_lint.api import fix
from bringup_lint.api import launch
from bringup_lint.api import note
from bringup_lint.api import regex
from bringup_lint.api import rule
from bringup_lint.api.launch import Started
from bringup_lint.api.spelling import nearest

BESIDE = ("exec_depend", "run_depend", "depend")
"""The dependencies below which another one is written, before those of building and testing."""
NAMED = {"exec_depend": "an exec_depend", "run_depend": "a run_depend"}
REST = regex(r"[ \t]*(?:<!--[^\n<>]*-->[ \t]*)?(?=\r?\n)")
"""The end of a line that has nothing or a comment."""
DEPENDENCY = regex(r"[ \t]*<\w+_?depend\b")
PLACEHOLDER = regex(r"^(?:your|my)_(?:package|pkg|robot|node)|package_name$")

ROSDEP = regex(r"\brosdep\s+install\b")


@rule(
    "error", fix="safe", symptoms=["PackageNotFoundError", "not found, searching", "package '*' not found, searching"]
)
def package_missing(robot: Robot) -> Iterator[Finding]:
    workspace = robot.launch.workspace
    seen = set()
    lacking: dict[launch.Package, list[Located]] = {}
    for node in robot.launch.nodes:
        package = launch.literal_text(node.package)
        owner = workspace.owner(node.file.source)
        if package is None or owner is None or package == owner.name or owner.depends_on(package):
            continue
        near = _near(robot, package)
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
        elif not robot.launch.comes_with(owner, package) and (owner.name, package) not in seen:
            seen.add((owner.name, str(package)))
            own = package in workspace.packages or package in workspace.ambiguous
            if not own and PLACEHOLDER.search(package):
                continue
            if not own and _is_lacking(robot, node, package):
                lacking.setdefault(owner, []).append(package)
            else:
                yield _undeclared(robot, owner, package, own)
    for owner, packages in lacking.items():
        yield _lacking(owner, packages)


def _near(robot: Robot, package: Located) -> launch.Package | None:
    """The package of the workspace that is meant by a name which nobody has."""
    workspace = robot.launch.workspace
    known = package in workspace.packages or package in workspace.ambiguous or robot.launch.is_known_package(package)
    near = nearest(package, sorted(workspace.packages)) if not known and len(package) > 5 else []
    names = [other for other in near if re.sub(r"\d", "", other) != re.sub(r"\d", "", package)]
    return workspace.packages[names[0]] if names else None


def _undeclared(robot: Robot, owner: launch.Package, package: Located, own: bool) -> Finding:
    workspace = robot.launch.workspace
    starts = workspace.packages.get(package)
    is_above = starts is not None and owner.name in workspace.required(starts)
    built = f"colcon build --packages-up-to {owner.name} leaves it out"
    tag = owner.manifest.tag_at_runtime
    return finding(
        package,
        f"{package} is not {NAMED[tag]} of {owner.name}: {built if own else 'rosdep does not install it'}",
        advice=f"{package} depends on {owner.name}: start it from a launch file of {package}"
        if is_above
        else f"add <{tag}>{package}</{tag}> to the package.xml",
        related=[note(owner.place, "the package that starts it")],
        fix=None if is_above else dependency(owner, package),
        severity="info",
    )


def _lacking(owner: launch.Package, packages: list[Located]) -> Finding:
    first, *others = packages
    more = "1 other package" if len(others) == 1 else f"{len(others)} other packages"
    names = f"{first} and {more}" if others else first
    tag = owner.manifest.tag_at_runtime
    return finding(
        first,
        f"Nothing of this tree declares or installs {names}: after its rosdep install, the launch aborts",
        advice=f"add <{tag}>{first}</{tag}> to the package.xml of {owner.name}",
        related=[*(note(other, f"{other} too") for other in others), note(owner.place, "the package that starts it")],
        fix=dependency(owner, *packages),
        severity="warning",
    )


def _is_lacking(robot: Robot, node: Started, package: str) -> bool:
    """Whether a public package is needed on the robot, which rosdep sets up, and nothing of the tree declares, installs
    or mentions it."""
    if node.by_default is not True or robot.launch.simulated(node.file) or not _is_installed(robot, node.file.source):
        return False
    if not any(ROSDEP.search(each.text) for each in robot.files.of_kind("dockerfile", "shell-script", "ansible")):
        return False
    return robot.launch.is_known_package(package) and not robot.launch.is_brought(package)


def _is_installed(robot: Robot, source: Source) -> bool:
    owner = robot.launch.workspace.owner(source)
    return owner is not None and owner.takes(os.path.abspath(source.name))


def dependency(owner: launch.Package, *packages: Located) -> Fix | None:
    """More dependencies below the last of their kind, past a comment in its line."""
    manifest = owner.manifest
    last = next((manifest.places[tag] for tag in (*BESIDE, *manifest.places) if tag in manifest.places), None)
    if last is None:
        return None
    source = last.source
    rest = REST.match(source.text, last.end)
    end = rest.end() if rest else last.end
    above = source.line_text(last.line)
    indent = above[: len(above) - len(above.lstrip())]
    gap = "\n" if _has_heading(last) else ""
    tag = manifest.tag_at_runtime
    added = "".join(f"\n{indent}<{tag}>{package}</{tag}>" for package in dict.fromkeys(map(str, packages)))
    return fix(f"add the {tag}", (source.span(end, end), f"{gap}{added}"))


def _has_heading(last: Span) -> bool:
    """Whether a comment begins the lines that a dependency is one of: it may not mean another one."""
    line = last.line - 1
    while line and DEPENDENCY.match(last.source.line_text(line)):
        line -= 1
    return line > 0 and last.source.line_text(line).rstrip().endswith("-->")
