"""A composable node gets text instead of a number with an exponent.

## What it finds
`1e-3`, `1e3` and `1.0e3` in files that launch itself reads for composable nodes. PyYAML reads a number only if it
has a point and a sign: `1.0e+3`. Left alone is a section that is switched off (`enabled: false`), because nothing reads
its values.

## Why it matters on a robot
rcl reads a double, but PyYAML reads text. The composable node gets a string where it declares a double, and does
not load.

## Bad
```yaml
filter:
  ros__parameters:
    epsilon: 1e-3
```

## Good
```yaml
filter:
  ros__parameters:
    epsilon: 1.0e-3
```

## When to ignore it
When the component declares the parameter as a string and converts it itself.

## References
- YAML 1.1, float; PyYAML's resolver
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

_EXPONENT = regex(r"([+-]?)([0-9]+)(\.[0-9]*)?[eE]([+-]?)([0-9]+)\Z")


@rule(
    "warning",
    fix="unsafe",
    symptoms=["InvalidParameterTypeException", "is of type {double}, setting it to {string} is not allowed"],
)
def exponent_pyyaml(robot: Robot) -> Iterator[Finding]:
    for file, parameter in robot.params.parameters:
        composed = next((load for load in robot.params.loads(file) if load.how == "pyyaml"), None)
        if not composed:
            continue
        for item in robot.params.items(parameter):
            found = None if item.quoted else _EXPONENT.match(item.text)
            if found is None or (found[3] and found[4]) or robot.params.is_switched_off(parameter):
                continue
            sign, whole, fraction, exponent_sign, exponent = found.groups()
            better = (
                f"{sign}{whole}{fraction if fraction and len(fraction) > 1 else '.0'}e{exponent_sign or '+'}{exponent}"
            )
            yield finding(
                item.span,
                f"launch reads '{item.text}' as text for the component {composed.node.label()}: it gets a string "
                "instead of a double",
                advice=f"write {better}",
                related=[note(composed.where, "loaded for a component here")],
                fix=fix(f"write {better}", (item.span, better)),
            )
