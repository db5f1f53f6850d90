"""A real robot waits for the time of a simulation.

## What it finds
`use_sim_time: true` in a file that the bring-up of a robot loads, when everything the launch file starts is known and
none of it simulates or sets the parameter again. Files and launch files for simulation, tests and recordings pass.

## Why it matters on a robot
Nobody publishes /clock: the time stays at zero and timers never fire. The nodes run and do nothing.

## Bad
```yaml
/**:
  ros__parameters:
    use_sim_time: true
```

## Good
```yaml
/**:
  ros__parameters:
    use_sim_time: false
```

## References
- https://github.com/ros2/rclcpp/issues/940
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import fix
from bringup_lint.api import note
from bringup_lint.api import rule


@rule("error", fix="unsafe")
def use_sim_time_real_robot(robot: Robot) -> Iterator[Finding]:
    for found in robot.params.simulated:
        yield finding(
            found.parameter.span,
            f"No /clock is published on the robot: the time of {found.load.node.label()} stays at zero, its timers "
            "never fire",
            advice="write false",
            related=[note(found.load.node.span, "gets the value here")],
            chain=robot.provenance.chain_to_load(found.load, note(found.parameter.span, "the node waits for /clock")),
            fix=fix("Write false", (found.parameter.span, "false"), safe=False),
        )
