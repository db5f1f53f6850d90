"""YAML reads text as a boolean, or a boolean as text.

## What it finds
Two mistakes with parameters that the sources of the workspace declare with a type. `on`, `off`, `yes`, `no`, `y`,
`n`, `true` or `false` without quotes for a string. Such a word with quotes for a boolean.

## Why it matters on a robot
ROS does not convert the value: the node exits with InvalidParameterTypeException at start.

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

## When to ignore it
When the declaration that the linter found belongs to another node than the one that loads the file.

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


@rule(
    "warning",
    fix="safe",
    symptoms=[
        "InvalidParameterTypeException",
        "is of type {string}, setting it to {bool} is not allowed",
        "is of type {bool}, setting it to {string} is not allowed",
    ],
)
def bool_like_string(robot: Robot) -> Iterator[Finding]:
    for parameter, declared in robot.params.typed:
        value = parameter.value
        if value.type == "bool" and declared.type == "string":
            text = f'"{parameter.text}"'
            yield finding(
                parameter.span,
                f"'{parameter.name}: {parameter.text}' is the boolean {str(value.data).lower()}, but the node "
                "expects a string: it exits with InvalidParameterTypeException",
                advice=f"write {text}",
                related=[note(declared.place, "declared as a string here")],
                fix=fix("put it in quotes", (parameter.span, text)),
            )
        elif value.type == "string" and declared.type == "bool" and str(value.data).lower() in _WORDS:
            plain = _WORDS[str(value.data).lower()]
            yield finding(
                parameter.span,
                f"'{parameter.name}: {parameter.text}' is text, but the node expects a boolean: it exits with "
                "InvalidParameterTypeException",
                advice=f"write {plain}",
                related=[note(declared.place, "declared as a boolean here")],
                fix=fix(f"write {plain}", (parameter.span, plain)),
            )
