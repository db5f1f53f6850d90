"""A package.xml that colcon, rosdep and ament refuse to read.

## What it finds
What catkin_pkg, with which all of them read the file, ends with an error for: XML that is not well-formed, a format
that is none of 1, 2 and 3, tags and attributes that the format does not have (`exec_depend` in format 1, `run_depend`
in formats 2 and 3), tags inside of others, a missing or second name, version or description, a missing maintainer or
license, names, versions and addresses in another form than they have, a package that depends on itself, and a `depend`
that repeats another dependency. Templates are left alone.

## Why it matters on a robot
colcon prints "Failed to parse ROS package manifest" and goes on: the package is no package of ROS any more. With a
CMakeLists.txt its build stops at ament_package; without one `ros2 run` and launch files do not find it. Dependencies
are not known, so that rosdep installs none, and colcon builds in any order.

## Bad
```xml
<package format="3">
  <exec_depends>rclpy</exec_depends>
```

## Good
```xml
<package format="3">
  <exec_depend>rclpy</exec_depend>
```

## When to ignore it
When a script fills in the file before the build.

## References
- REP 140, REP 149
- catkin_pkg 1.1, `package.py`: `parse_package_string`, `Package.validate` (compared in `tests/oracles/`)
- colcon-ros, `package_identification/ros.py`
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Problem
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import note
from bringup_lint.api import rule
from bringup_lint.api.packages import Manifest
from bringup_lint.api.packages import tags_of_format
from bringup_lint.api.spelling import nearest

_SAID = {
    "not-well-formed": "it is not well-formed XML",
    "root": "its outermost tag is {word} instead of package",
    "format": "there is no format {word}",
    "attribute": "format {form} has no attribute {word} of <{detail}>",
    "tag": "format {form} has no tag {word}",
    "child": "<{detail}> takes no other tag",
    "missing": "it has no {detail}",
    "twice": "it has a second {detail}",
    "empty": "its {detail} is empty",
    "name": "{word} is not a name of a package",
    "version": "{word} is not a version of three numbers",
    "email": '"{word}" is not an address of email',
    "no-email": "the maintainer has no email",
    "itself": "{word} depends on itself",
    "redundant": "<{detail}> says again that it needs {word}",
}
"""Code of a problem -> what is wrong."""
_ADVICE = {
    "not-well-formed": "close each tag with its own name",
    "root": "write package",
    "format": 'write format="3"',
    "attribute": "remove it",
    "child": "write only text in it",
    "missing": "add <{detail}>",
    "twice": "remove one of them",
    "empty": "fill it in",
    "name": "write letters, digits and underscores, the first one a letter",
    "version": "write one such as 1.0.0",
    "email": "write one such as name@example.com",
    "no-email": 'add email="..."',
    "itself": "remove the line",
    "redundant": "remove the line",
}


@rule(
    "error",
    symptoms=[
        "Failed to parse ROS package manifest in",
        "The manifest contains invalid XML",
        "must not contain the following tags",
        "The manifest must contain exactly one",
    ],
)
def manifest_refused(robot: Robot) -> Iterator[Finding]:
    for manifest in robot.dependencies.manifests:
        if not manifest.refused:
            continue
        first, *others = manifest.refused
        yield finding(
            first.span,
            f"colcon and rosdep do not read this package.xml, for {_said(manifest, first)}: "
            f"{manifest.name or 'the package'} is not built as a package of ROS",
            advice=_advice(manifest, first),
            related=[note(each.span, f"also refused: {_said(manifest, each)}") for each in others],
        )


def _said(manifest: Manifest, problem: Problem) -> str:
    if problem.code == "attribute" and problem.detail == "package":
        return f"<package> has no attribute {problem.span.text}"
    return _SAID[problem.code].format(word=problem.span.text, detail=problem.detail, form=manifest.format)


def _advice(manifest: Manifest, problem: Problem) -> str:
    known = tags_of_format(manifest.format)
    word = problem.span.text
    near = nearest(word, known if problem.code == "tag" else [])
    if problem.code == "attribute":
        near = nearest(word, ["format", *known.get(problem.detail, ())])
    if near:
        return f"write {near[0]}"
    if problem.code == "tag":
        newer = word in tags_of_format(3)
        return 'write <package format="3">' if newer else "write exec_depend" if word == "run_depend" else "remove it"
    return _ADVICE[problem.code].format(detail=problem.detail)
