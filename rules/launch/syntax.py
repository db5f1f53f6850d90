"""A launch file cannot be parsed.

## What it finds
Python launch files with a syntax error, XML and YAML launch files that are not well-formed (also `--` inside an XML
comment), and YAML launch files that are not a list of tags.

## Why it matters on a robot
`ros2 launch` stops before it starts a single node. A unit that runs it fails at every boot.

## Bad
```xml
<launch>
  <node pkg="demo" exec="talker">
</launch>
```

## Good
```xml
<launch>
  <node pkg="demo" exec="talker"/>
</launch>
```

## When to ignore it
Only for a file that is not launched, such as a test of a parser or a template that a generator fills in.

## References
- Launch file architecture of ROS 2, "Static launch description files"
"""

import sys
from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Problem
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import rule
from bringup_lint.api.yaml import YamlCode

IGNORED = {
    "doctype",
    "no-launch-root",
    "too-large",
    YamlCode.ALIAS_BOMB,
}

OLD = ("foxy", "galactic", "humble", "iron")
"""Their Python reads f-strings as old as ours does; from Jazzy on, quotes may be nested in them."""


@rule(
    "error",
    symptoms=[
        "invalid syntax",
        "mismatched tag",
        "The launch file may have a syntax error, or its format is unknown",
        "Expected 'launch' as root tag",
        "not well-formed (invalid token)",
    ],
)
def syntax(robot: Robot) -> Iterator[Finding]:
    for file in robot.launch.judged:
        for problem in file.problems[:1]:
            newer = sys.version_info < (3, 12) and problem.code == "f-string"
            ignored = problem.code in IGNORED or _other_version(problem)
            if not ignored and not (newer and robot.target.ros not in OLD):
                detail = f" ({problem.detail})" if problem.detail else ""
                yield finding(
                    problem.where,
                    f"The launch file has a syntax error{detail}: nothing starts",
                    advice="correct the line",
                )
        for refused in robot.launch.refusals(file):
            if refused.code == "shape":
                yield finding(
                    refused.where,
                    f"The launch file has a syntax error ({refused.message}): nothing starts",
                    advice="correct the line",
                )


def _other_version(problem: Problem) -> bool:
    """Python reads XML of any version."""
    return problem.code == "bad-declaration" and "version=" in problem.span.text
