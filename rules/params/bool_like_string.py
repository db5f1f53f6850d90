"""YAML reads text as a boolean or number, or one of these as text.

## What it finds
Mistakes with parameters that the sources of the workspace declare with a type: `on`, `off`, `yes`, `no`, `y`, `n`,
`true` or `false` without quotes for a string, or with quotes for a boolean; a number without quotes for a string; and
text for a number, such as `"18"` or `0,8`.

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
from bringup_lint.api import regex
from bringup_lint.api import rule

_WORDS = {"true": "true", "yes": "true", "on": "true", "false": "false", "no": "false", "off": "false"}

_DIGIT = regex(r"[0-9]")
_NUMBERS = {"integer": "an integer", "double": "a double"}


@rule(
    "warning",
    fix="safe",
    symptoms=[
        "InvalidParameterTypeException",
        "is of type {string}, setting it to {bool} is not allowed",
        "is of type {bool}, setting it to {string} is not allowed",
        "is of type {string}, setting it to {integer} is not allowed",
        "is of type {integer}, setting it to {string} is not allowed",
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
        elif value.type in _NUMBERS and declared.type == "string":
            yield finding(
                parameter.span,
                f"'{parameter.name}: {parameter.text}' is a number, but the node expects a string: it exits with "
                "InvalidParameterTypeException",
                advice=f'write "{parameter.text}"',
                related=[note(declared.place, "declared as a string here")],
                fix=fix("put it in quotes", (parameter.span, f'"{parameter.text}"')),
            )
        elif value.type == "string" and declared.type in _NUMBERS and _DIGIT.search(str(value.data)):
            wanted = _NUMBERS[declared.type]
            yield finding(
                parameter.span,
                f"'{parameter.name}: {parameter.text}' is text, but the node expects {wanted}: it exits with "
                "InvalidParameterTypeException",
                advice=f"write {wanted} without quotes, with a point before its decimals",
                related=[note(declared.place, f"declared as {wanted} here")],
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
