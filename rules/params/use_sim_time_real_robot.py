"""A real robot waits for a simulated clock.

## What it finds
`use_sim_time: true` in a file that the bring-up of a robot loads. Reported only when everything that the launch
file starts is known, and none of it simulates or sets the parameter again. Files for simulation, tests and
recordings are not reported.

## Why it matters on a robot
Nothing publishes /clock: the time stays at zero, and timers never fire. The nodes run and do nothing.

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

## When to ignore it
When a program outside this tree publishes /clock on the robot, for example a hardware-in-the-loop bench.

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
from bringup_lint.api.params import simulated


@rule("error", fix="unsafe", symptoms=["No clock received, using time argument instead!"])
def use_sim_time_real_robot(robot: Robot) -> Iterator[Finding]:
    for found in simulated(robot.params):
        yield finding(
            found.parameter.span,
            f"Nothing publishes /clock on the robot: the ROS time of {found.load.node.label()} stays at zero, in its "
            "stamps and in all that waits for that time",
            advice="write false",
            related=[note(found.load.node.span, "gets the value here")],
            chain=robot.provenance.chain_to_load(found.load, note(found.parameter.span, "the node waits for /clock")),
            fix=fix("write false", (found.parameter.span, "false"), safe=False),
        )
