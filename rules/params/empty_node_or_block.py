"""A node or its parameter block is empty.

## What it finds
A node name or `ros__parameters` with nothing below it, as when all parameters are commented out. An explicit `{}`
is valid.

An error where a launch file of the tree gives the file to a node, info where the tree has launch files and nothing
names the file, else a warning.

## Why it matters on a robot
rcl rejects the whole file: 'Cannot have a value before ros__parameters'. Every node that loads it exits at start.

## Bad
```yaml
motors:
  ros__parameters:
    # rate: 50
```

## Good
```yaml
motors:
  ros__parameters: {}
    # rate: 50
```

## When to ignore it
When a script fills in the block before a node loads the file.

## References
- rcl_yaml_param_parser, `parse_file_events`
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import Source
from bringup_lint.api import finding
from bringup_lint.api import fix
from bringup_lint.api import params
from bringup_lint.api import regex
from bringup_lint.api import rule

VALUE = regex(r"[ \t]*(?:[&!~]|null\b)")


@rule("error", fix="safe", symptoms=["Cannot have a value before ros__parameters"])
def empty_node_or_block(robot: Robot) -> Iterator[Finding]:
    for file, problem in robot.params.problems("empty-block"):
        if robot.params.read_by(file) == "pyyaml":
            continue
        key = problem.word
        inner = "{}" if key.startswith("ros__parameters") else "{ros__parameters: {}}"
        colon = file.source.text.find(":", key.span.end)
        place = file.source.span(colon + 1, colon + 1)
        change = fix(f"write {inner}", (place, f" {inner}"))
        yield finding(
            key,
            f"'{key}' is empty: the process that loads the file exits at start",
            advice=f"write {inner}, or remove the block",
            fix=change if colon >= 0 and not _has_node(file.source, colon) else None,
            severity=params.severity_of_refusal(robot.params, file),
        )


def _has_node(source: Source, colon: int) -> bool:
    """Whether an anchor, a tag or a written null follows the colon: a value before it is not YAML."""
    return VALUE.match(source.text, colon + 1) is not None
