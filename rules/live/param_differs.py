"""A node runs with another value of a parameter than its file says.

## What it finds
Numbers and switches that a parameter file gives a node of a launch file, where the running node of this name has
another value. Texts and lists are not compared. `bringup-lint live` asks the nodes for these parameters alone.

## Why it matters on a robot
The value was changed while the robot ran (`ros2 param set`, rqt), or another file reached the node. The robot works
until the next start brings back the old value; or a limit that the file lowers does not hold.

## Bad
```yaml
# the file says max_speed: 0.5
parameters:
- {node: /base, name: max_speed, value: "1.5"}
```

## Good
```yaml
# the file says max_speed: 0.5
parameters:
- {node: /base, name: max_speed, value: "0.5"}
```

## When to ignore it
When something of the robot sets the parameter while it runs, such as a mode switch.

## References
- ROS 2 documentation, "Parameters"
- rcl_interfaces, "GetParameters.srv"
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import note
from bringup_lint.api import rule


@rule("warning", silent="no program compares the value with the file")
def param_differs(robot: Robot) -> Iterator[Finding]:
    for given, running in robot.observed.other_values:
        file = given.where.path.rpartition("/")[2]
        yield finding(
            given.where,
            f"{given.node} runs with {given.name} = {running}, but {file} says {given.where.text}",
            advice="write the value that is right into the file, and restart the node",
            related=[note(running, "the value of the running node")],
        )
