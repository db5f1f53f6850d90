"""A number is written in a way that ROS reads as text.

## What it finds
`0o10`, `0b11` and `1_000` without quotes.

## Why it matters on a robot
rcl reads them as strings. A node that declares a number rejects the value and exits.

## Bad
```yaml
motors:
  ros__parameters:
    baudrate: 115_200
```

## Good
```yaml
motors:
  ros__parameters:
    baudrate: 115200
```

## When to ignore it
When the node declares a string and parses the number itself, in a place that the linter does not see.

## References
- rcl_yaml_param_parser, `get_value`
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import fix
from bringup_lint.api import params
from bringup_lint.api import regex
from bringup_lint.api import rule

_NUMBER = regex(r"0o[0-7]+|0b[01]+|[+-]?[1-9][0-9]{0,2}(?:_[0-9]{3})+(?:\.[0-9]+)?")


@rule(
    "warning",
    fix="unsafe",
    symptoms=[
        "InvalidParameterTypeException",
        "is of type {integer}, setting it to {string} is not allowed",
        "is of type {double}, setting it to {string} is not allowed",
    ],
)
def yaml12_number(robot: Robot) -> Iterator[Finding]:
    for _, parameter in robot.params.parameters:
        if params.declared_type(robot.params, parameter) == "string":
            continue
        for item in robot.params.items(parameter):
            if item.type == "string" and not item.quoted and _NUMBER.fullmatch(item.text):
                plain = str(int(item.text, 0)) if item.text[:2] in ("0o", "0b") else item.text.replace("_", "")
                yield finding(
                    item.span,
                    f"'{item.text}' is the text \"{item.text}\" for ROS, not a number",
                    advice=f"write {plain}",
                    fix=fix(f"write {plain}", (item.span, plain), safe=False),
                )
