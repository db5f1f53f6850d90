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
from bringup_lint.api.params import Declared
from bringup_lint.api.params import Parameter

_WORDS = {"true": "true", "yes": "true", "on": "true", "false": "false", "no": "false", "off": "false"}

_NUMBER = regex(r"\s*[+-]?[.,]?[0-9]")
"""How a text begins that is meant for a number, and is no placeholder."""
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
        given = parameter.value.type
        if declared.type == "string" and given == "bool":
            yield of_string(parameter, declared, f"the boolean {str(parameter.value.data).lower()}")
        elif declared.type == "string" and given in _NUMBERS:
            yield of_string(parameter, declared, "a number")
        elif declared.type in _NUMBERS and given == "string" and _NUMBER.match(str(parameter.value.data)):
            yield of_number(parameter, declared, _NUMBERS[declared.type])
        elif declared.type == "bool" and given == "string" and str(parameter.value.data).lower() in _WORDS:
            yield of_boolean(parameter, declared, _WORDS[str(parameter.value.data).lower()])


def of_string(parameter: Parameter, declared: Declared, given: str) -> Finding:
    text = f'"{parameter.text}"'
    return finding(
        parameter.span,
        _message(parameter, given, "a string"),
        advice=f"write {text}",
        related=[note(declared.place, "declared as a string here")],
        fix=fix("put it in quotes", (parameter.span, text)),
    )


def of_number(parameter: Parameter, declared: Declared, wanted: str) -> Finding:
    return finding(
        parameter.span,
        _message(parameter, "text", wanted),
        advice=f"write {wanted} without quotes, with a point before its decimals",
        related=[note(declared.place, f"declared as {wanted} here")],
    )


def of_boolean(parameter: Parameter, declared: Declared, plain: str) -> Finding:
    return finding(
        parameter.span,
        _message(parameter, "text", "a boolean"),
        advice=f"write {plain}",
        related=[note(declared.place, "declared as a boolean here")],
        fix=fix(f"write {plain}", (parameter.span, plain)),
    )


def _message(parameter: Parameter, given: str, wanted: str) -> str:
    written = f"'{parameter.name}: {parameter.text}'"
    return f"{written} is {given}, but the node expects {wanted}: it exits with InvalidParameterTypeException"
