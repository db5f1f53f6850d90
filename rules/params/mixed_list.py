"""A list mixes types.

## What it finds
Lists whose elements have different types for rcl, such as `[0, 0.5]` or `[1, null]`. A warning in files that only
PyYAML reads.

An error where a launch file of the tree gives the file to a node, info where the tree has launch files and nothing
names the file, else a warning.

## Why it matters on a robot
rcl rejects the whole file: 'Sequence should be of same type'. Every node that loads it exits at start.

## Bad
```yaml
motors:
  ros__parameters:
    gains: [0, 0.5]
```

## Good
```yaml
motors:
  ros__parameters:
    gains: [0.0, 0.5]
```

## When to ignore it
When the node parses the file itself and rcl never reads it.

## References
- rcl_yaml_param_parser, `parse_value`
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import fix
from bringup_lint.api import params
from bringup_lint.api import regex
from bringup_lint.api import rule

_DECIMAL = regex(r"[+-]?(?:0|[1-9][0-9]*)\Z")


@rule("error", fix="safe", symptoms=["Sequence should be of same type"])
def mixed_list(robot: Robot) -> Iterator[Finding]:
    for file, parameter in robot.params.refused("mixed-list"):
        items = robot.params.items(parameter)
        if any("$(" in item.text for item in items):
            continue
        types = list(dict.fromkeys(item.type for item in items))
        doubles = {"integer", "double"} == set(types)
        whole = [item for item in items if item.type == "integer"]
        only_pyyaml = robot.params.read_by(file) == "pyyaml"
        yield finding(
            parameter.span,
            f"'{parameter.name}' mixes {' and '.join(types)}: "
            + ("the node gets no usable list" if only_pyyaml else "the process that loads the file exits at start"),
            advice=f"write {', '.join(f'{item.text}.0' for item in whole[:3])}" if doubles else "use one type",
            fix=fix("write doubles", *((item.span, f"{item.text}.0") for item in whole), safe=not only_pyyaml)
            if doubles and all(_DECIMAL.match(item.text) for item in whole)
            else None,
            severity=params.severity_of_refusal(robot.params, file),
        )
