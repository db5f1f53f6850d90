"""use_sim_time is not a boolean.

## What it finds
`use_sim_time` as a quoted string or as a number in parameter files. Files that are only for composable nodes are
not reported: launch parses the text again.

## Why it matters on a robot
The node's clock rejects the value. The node logs an error and stays on wall time while the others follow the
simulation, or it exits with an exception.

## Bad
```yaml
/**:
  ros__parameters:
    use_sim_time: "true"
```

## Good
```yaml
/**:
  ros__parameters:
    use_sim_time: true
```

## When to ignore it
Never: rclcpp and rclpy accept only a boolean.

## References
- rclcpp, `TimeSource`: "Invalid type ... for parameter 'use_sim_time', should be 'bool'"
- https://github.com/ros/joint_state_publisher/issues/103
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import fix
from bringup_lint.api import rule

_PLAIN = {
    "true": "true",
    "1": "true",
    "yes": "true",
    "on": "true",
    "false": "false",
    "0": "false",
    "no": "false",
    "off": "false",
}


@rule("error", fix="safe", symptoms=["Invalid type", "use_sim_time parameter cannot be set to anything but a bool"])
def use_sim_time_not_bool(robot: Robot) -> Iterator[Finding]:
    for file, parameter in robot.params.parameters:
        value = parameter.value
        if parameter.name != "use_sim_time" or value.type in ("bool", "not_set") or "$(" in parameter.text:
            continue
        if {load.how for load in robot.params.loads(file)} == {"pyyaml"}:
            continue
        plain = _PLAIN.get(str(value.data).strip().lower())
        yield finding(
            parameter.span,
            f"use_sim_time is the {value.type.replace('_', ' ')} {parameter.text}, not a boolean: the node rejects "
            "it and stays on wall time",
            advice=f"write {plain or 'true or false'}",
            fix=fix(f"write {plain}", (parameter.span, plain), safe=plain == "false") if plain else None,
        )
