"""A number with a leading zero is read as octal.

## What it finds
Integers with a leading zero. `0`, `0.5` and quoted text are not reported.

## Why it matters on a robot
`010` is 8 for rcl and for PyYAML. `08` is the double 8.0.

## Bad
```yaml
motors:
  ros__parameters:
    id: 010
```

## Good
```yaml
motors:
  ros__parameters:
    id: 10
```

## When to ignore it
When the value is meant as octal, such as a file mode.

## References
- rcl_yaml_param_parser, `get_value` (strtoll with base 0)
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import fix
from bringup_lint.api import regex
from bringup_lint.api import rule

_OCTAL = regex(r"[+-]?0+[1-9][0-9]*\Z")


@rule("warning", fix="unsafe", symptoms=["is of type {integer}, setting it to {double} is not allowed"])
def octal(robot: Robot) -> Iterator[Finding]:
    for _, parameter in robot.params.parameters:
        for item in robot.params.items(parameter):
            if item.type in ("integer", "double") and _OCTAL.match(item.text):
                sign = item.text[0] if item.text[0] in "+-" else ""
                plain = sign + item.text.lstrip("+-0")
                if item.type == "integer" and int(plain) == item.data:
                    continue
                yield finding(
                    item.span,
                    f"'{item.text}' is read as the {item.type} {item.data}",
                    advice=f"write {plain}, or {item.data}",
                    fix=fix(f"write {plain}", (item.span, plain), safe=False),
                )
