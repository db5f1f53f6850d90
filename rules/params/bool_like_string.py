"""A word is read as a boolean where the node expects text, or the other way round.

## What it finds
`on`, `off`, `yes`, `no`, `y`, `n`, `true` and `false` without quotes for parameters that the workspace declares as a
string, and with quotes for those that it declares as a boolean.

## Why it matters on a robot
ROS does not convert: the node ends with InvalidParameterTypeException at start.

## Bad
```yaml
fan:
  ros__parameters:
    mode: on
```

## Good
```yaml
fan:
  ros__parameters:
    mode: "on"
```

## References
- rcl_yaml_param_parser, `get_value`
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import fix
from bringup_lint.api import note
from bringup_lint.api import rule

_WORDS = {"true": "true", "yes": "true", "on": "true", "false": "false", "no": "false", "off": "false"}


@rule("warning", fix="safe", symptoms=["InvalidParameterTypeException"])
def bool_like_string(robot: Robot) -> Iterator[Finding]:
    for parameter, declared in robot.params.typed:
        value = parameter.value
        if value.type == "bool" and declared.type == "string":
            text = f'"{parameter.text}"'
            yield finding(
                parameter.span,
                f"'{parameter.name}: {parameter.text}' is the boolean {str(value.data).lower()}, the node expects a "
                "string: it ends with InvalidParameterTypeException",
                advice=f"write {text}",
                related=[note(declared.place, "declared as a string here")],
                fix=fix("Put it in quotes", (parameter.span, text)),
            )
        elif value.type == "string" and declared.type == "bool" and str(value.data).lower() in _WORDS:
            plain = _WORDS[str(value.data).lower()]
            yield finding(
                parameter.span,
                f"'{parameter.name}: {parameter.text}' is text, the node expects a boolean: it ends with "
                "InvalidParameterTypeException",
                advice=f"write {plain}",
                related=[note(declared.place, "declared as a boolean here")],
                fix=fix(f"Write {plain}", (parameter.span, plain)),
            )
