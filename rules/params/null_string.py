"""A null is read as text.

## What it finds
`null`, `~` and `None` as values; lower-case `none` for information. Silent for parameters that the node declares as
text.

## Why it matters on a robot
rcl has no null: the node gets the text "null", not 'unset'.

## Bad
```yaml
motors:
  ros__parameters:
    calibration: null
```

## Good
```yaml
motors:
  ros__parameters:
    calibration: ""
```

## References
- rcl_yaml_param_parser, `get_value`
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import rule

_NULLS = ("null", "~", "NULL", "Null", "None", "none")


@rule("warning")
def null_string(robot: Robot) -> Iterator[Finding]:
    for file, parameter in robot.params.parameters:
        if robot.params.reader(file) == "pyyaml":
            continue
        for item in robot.params.items(parameter):
            if item.quoted or item.text not in _NULLS or robot.params.declared_type(parameter) == "string":
                continue
            yield finding(
                item.span,
                f"'{parameter.name}' is the text \"{item.text}\", not 'unset'",
                advice="remove the line, so that the node's default stays",
                severity="info" if item.text in ("none", "None") else None,
            )
