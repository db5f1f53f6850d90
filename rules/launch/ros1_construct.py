"""A launch file uses the syntax of ROS 1.

## What it finds
`<node type=>`, `ns=`, `required=`, `$(arg x)`, `$(find p)`, `<rosparam>`, `<machine>` and `<arg value=>` in ROS 2
launch files. A ROS 1 launch file in a ROS 2 package is a warning. Files of an archive are left out: those in folders
such as `legacy`, `old` or `unported`. It is an info where no launch file speaks of the file, and the build does not
install it, or it is a test that the build does not name, or lies in a folder `include`.

## Why it matters on a robot
ROS 2 launch rejects the file. Nothing starts.

## Bad
```xml
<node pkg="demo" type="talker" name="talker" ns="$(arg robot)"/>
```

## Good
```xml
<node pkg="demo" exec="talker" name="talker" namespace="$(var robot)"/>
```

## When to ignore it
Only for a ROS 1 file that is kept as a reference during a migration. With `ros1` in its path it is not reported.

## References
- "Migrating launch files from ROS 1 to ROS 2"
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Located
from bringup_lint.api import Purpose
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import fix
from bringup_lint.api import note
from bringup_lint.api import regex
from bringup_lint.api import rule
from bringup_lint.api.launch import LaunchFile
from bringup_lint.api.launch import names_beside

INSTEAD = {"type": "exec", "arg": "var", "find": "find-pkg-share", "ns": "namespace"}
WORDS = {
    "rosparam": '<param from="…">',
    "required": 'on_exit="shutdown"',
    "optenv": "$(env NAME default)",
    "param": "<set_parameter>",
}

INCLUDED = regex(r"(?:^|/)includes?/[^/]*$")


@rule("error", fix="safe", symptoms=["Unexpected attribute(s) found in `node`", "Unknown substitution: arg"])
def ros1_construct(robot: Robot) -> Iterator[Finding]:
    for file in robot.launch.judged:
        if not file.ros1 or robot.purpose(file.source) is Purpose.ARCHIVE:
            continue
        if file.source.name.endswith(".launch") and is_for_both(robot, file):
            continue
        edits = [(name, INSTEAD[name]) for name in file.ros1 if _is_replaceable(name)]
        name, *others = in_order(file)
        yield finding(
            name,
            f"'{name}' is ROS 1 syntax: ROS 2 launch rejects the file",
            advice=f"write {instead(name)}",
            related=[note(each, f"'{each}' is ROS 1 syntax, too: write {instead(each)}") for each in others],
            fix=fix("write it as ROS 2 does", *edits) if edits else None,
            severity="info" if is_out_of_use(robot, file) else None,
        )
    for first, *rest in left_behind(robot).values():
        name = in_order(first)[0]
        yield finding(
            name,
            f"'{name}' is ROS 1 syntax in a ROS 2 package: ros2 launch rejects this file",
            advice="migrate the file, or remove it",
            severity="info" if all(is_out_of_use(robot, each) for each in (first, *rest)) else "warning",
            related=[note(in_order(each)[0], "ROS 1 syntax, too") for each in rest],
        )


def in_order(file: LaunchFile) -> list[Located]:
    return sorted(file.ros1, key=lambda each: each.span.start)


def left_behind(robot: Robot) -> dict[str, list[LaunchFile]]:
    """The launch files of ROS 1 in packages of ROS 2, by package and folder."""
    found: dict[str, list[LaunchFile]] = {}
    for file in robot.launch.ros1:
        package = robot.launch.workspace.owner(file.source)
        if "ros1" in file.source.name.lower() or is_for_both(robot, file):
            continue
        if package is not None and not package.manifest.is_ros1 and package.manifest.build_type and file.ros1:
            found.setdefault(file.source.name.rpartition("/")[0], []).append(file)
    return found


def is_out_of_use(robot: Robot, file: LaunchFile) -> bool:
    """Whether no other launch file speaks of one, and the build does not install it, or run it as a test, or it is only
    there to be included."""
    if robot.launch.is_unrun_test(file.source) or INCLUDED.search(file.source.name):
        return not robot.launch.is_named_elsewhere(file)
    return robot.launch.workspace.leaves_out(file.source) and not robot.launch.is_named_elsewhere(file)


def is_for_both(robot: Robot, file: LaunchFile) -> bool:
    """Whether the package of a launch file is one of ROS 1 as well."""
    package = robot.launch.workspace.owner(file.source)
    return package is not None and package.manifest.for_both


def _is_replaceable(name: Located) -> bool:
    """Whether there is one name to write, and the tag does not have an attribute of that name already."""
    return name in INSTEAD and name.span.text == name and INSTEAD[name] not in names_beside(name)


def instead(name: str) -> str:
    return INSTEAD.get(name) or WORDS.get(name, "the ROS 2 equivalent")
