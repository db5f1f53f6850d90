"""A parameter is set twice in one block.

## What it finds
The same parameter twice under one `ros__parameters`. An error when the types differ, a warning when only the values
differ, and info when both are equal, or lie in a section that is not in use: one with `enabled: false`, or a plugin of
Navigation2 that no list of its node has, nor the default of a list that is not written.

## Why it matters on a robot
If both have the same type, the last value applies. If the types differ, rcl keeps both and passes on the one whose
type comes first (bool, integer, double, string), regardless of the order in the file.

## Bad
```yaml
motors:
  ros__parameters:
    rate: 50
    rate: fast
```

## Good
```yaml
motors:
  ros__parameters:
    rate: 50
```

## When to ignore it
Never: one of the two lines has no effect. Delete it.

## References
- rcl_yaml_param_parser, `parse_value`
- rclcpp, `parameter_value_from`
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import note
from bringup_lint.api import rule


@rule("warning", silent="rcl keeps one of the values without a message")
def duplicate_key(robot: Robot) -> Iterator[Finding]:
    for file, first, second in robot.params.duplicates:
        wins = robot.params.winner(file, second)
        same = first.value == second.value
        is_idle = same or robot.params.is_switched_off(second)
        differ = first.value.type != second.value.type
        yield finding(
            second.key,
            f"'{second.name}' is set twice: the {wins.type.replace('_', ' ')} {wins.data!r} applies"
            if differ and wins is not None
            else f"'{second.name}' is set twice: " + ("both are equal" if same else "only the last value applies"),
            advice="keep one of them",
            related=[note(first.key, "set here before")],
            severity="info" if is_idle else "error" if differ and wins is not None else None,
        )
