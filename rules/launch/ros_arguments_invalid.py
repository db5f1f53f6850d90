"""ROS arguments that rcl refuses.

## What it finds
After `--ros-args`, in launch files and in the commands of units, compose services, images and scripts: options that rcl
does not know, options without their value, remap rules and parameter rules that cannot be parsed, unknown log levels.

## Why it matters on a robot
The node ends at its start with `RCLInvalidROSArgsError` or `UnknownROSArgsError`. With `respawn` or `Restart=` it does
so forever.

## Bad
```python
Node(package='demo', executable='driver', arguments=['--ros-args', '-p', 'rate=50', '--loglevel', 'debug'])
```

## Good
```python
Node(package='demo', executable='driver', arguments=['--ros-args', '-p', 'rate:=50', '--log-level', 'debug'])
```

## When to ignore it
When the program takes its arguments apart before it gives them to ROS.

## References
- https://docs.ros.org/en/jazzy/How-To-Guides/Node-arguments.html
- rcl, `rcl_parse_arguments`
"""

from __future__ import annotations

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Problem
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import fix
from bringup_lint.api import launch
from bringup_lint.api import regex
from bringup_lint.api import rule
from bringup_lint.api.ros import ros_arguments
from bringup_lint.api.spelling import nearest

ADVICE = {
    "ros-value-missing": "give its value, or remove it",
    "remap-rule": "write from:=to, each a name of letters, digits and '_' in parts between '/'",
    "parameter-rule": "write name:=value, with a value that is YAML but no mapping",
    "log-level": "write debug, info, warn, error or fatal",
}
SPLIT = "give each word as an argument of its own"
END = "remove it, or end the ROS arguments with --"
WRONG = {
    "ros-value-missing": "has no value",
    "remap-rule": "is no remap rule",
    "parameter-rule": "is no parameter rule",
    "log-level": "is no log level",
    "ros-flag": "is no ROS argument",
}
KNOWN = (*ros_arguments.FLAGS, *ros_arguments.SWITCHES, "--ros-args")
UNKNOWN = regex(r"[$`%*]")
"""What a shell, systemd or a template fills in."""


@rule(
    "error",
    fix="unsafe",
    symptoms=[
        "RCLInvalidROSArgsError",
        "UnknownROSArgsError",
        "Couldn't parse remap rule",
        "Failed to parse global arguments",
        "Couldn't parse parameter override rule",
        "Couldn't parse log level",
        "No parameter override rule found.",
        "Couldn't parse enclave name",
        "Argument has an invalid logger item",
    ],
)
def ros_arguments_invalid(robot: Robot) -> Iterator[Finding]:
    if robot.has_launch_files:
        judged = {id(file) for file in robot.launch.judged}
        for node in robot.launch.nodes:
            if id(node.file) in judged and node.is_node and not isinstance(node.action, launch.ComposableNode):
                yield from of_node(node)
    for runner in robot.runners.ros:
        for start in runner.starts:
            if start.ros.kind in ("run", "node"):
                words = [None if UNKNOWN.search(word) else word for word in start.ros.arguments]
                yield from map(described, ros_arguments.problems(words))


def of_node(node: launch.Started) -> Iterator[Finding]:
    if "shell" in node.options:
        return
    own = len(getattr(node.action, "arguments", node.arguments))
    words = [launch.literal_text(value) for value in node.arguments]
    yield from map(described, ros_arguments.problems(words[:own]))
    yield from map(described, ros_arguments.problems(words[own:], inside=True))


def described(problem: Problem) -> Finding:
    word = problem.word
    near = nearest(word, KNOWN, 3) if problem.code == "ros-flag" else []
    single = len(near) == 1 and word.span.text == word
    blank = problem.code == "ros-flag" and " " in word.strip()
    return finding(
        word,
        f"'{word}' {WRONG[problem.code]}: the process ends at its start",
        advice=f"write {near[0]}" if near else ADVICE.get(problem.code, SPLIT if blank else END),
        fix=fix(f"write {near[0]}", (word, near[0]), safe=False) if single else None,
    )
