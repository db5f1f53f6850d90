"""A null is read as text.

## What it finds
`null` and `~` as values: a warning where a node of the tree declares the parameter with another type than a string, and
info where no declaration is known. `None` and `none` as values, as info. Silent for parameters that the node declares
as a string. Quotes inside of quotes, as a warning: `"''"` is a text of two quotes and not an empty one.

## Why it matters on a robot
rcl has no null: the node gets the text "null", not an unset parameter. Where the text is two quotes, it looks for a
device or a frame of that name.

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

## When to ignore it
When the node compares the value with this very text.

## References
- rcl_yaml_param_parser, `get_value`
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import params
from bringup_lint.api import rule

_UNKNOWN = "one that declares another type than a string exits with an exception"
_QUOTES = ("''", '""')
_NULLS = ("null", "~", "NULL", "Null", "None", "none")


@rule("warning", symptoms=["Trying to set parameter '*' to 'null' of type 'STRING', expecting type"])
def null_string(robot: Robot) -> Iterator[Finding]:
    for file, parameter in robot.params.parameters:
        if robot.params.read_by(file) == "pyyaml":
            continue
        for item in robot.params.items(parameter):
            if item.quoted and item.text in _QUOTES:
                yield finding(
                    item.span,
                    f"'{parameter.name}' is a text of two quotes for the node, not an empty one",
                    advice='write ""',
                    severity="warning",
                )
                continue
            declared = params.declared_type(robot.params, parameter)
            if item.quoted or item.text not in _NULLS or declared == "string":
                continue
            yield finding(
                item.span,
                f"'{parameter.name}' is the text \"{item.text}\" for the node, not an unset parameter: "
                + (f"the node declares the type {declared} and exits with an exception" if declared else _UNKNOWN),
                advice="remove the line, so that the node keeps its default",
                severity="info" if item.text in ("none", "None") or declared is None else None,
            )
