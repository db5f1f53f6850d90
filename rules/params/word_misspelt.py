"""A value is a letter away from the words that its program knows.

## What it finds
Parameters whose program compares the value with a fixed list of words, and whose value is one letter away from exactly
one of them: solvers and strategies of slam_toolbox, the models of amcl, the feedback of velocity_smoother, motion
models, types and actions of the collision monitor, types of joy_teleop, libraries of behavior trees, interfaces of
controllers. The same in the YAML files of maps (`mode`), cameras (`distortion_model`), bridges to Gazebo
(`direction`), recordings (`storage_identifier`) and MoveIt (solvers, planners, controllers, sensors).

## Why it matters on a robot
A node of Navigation2 ends when it configures, and the lifecycle manager takes the whole stack down. slam_toolbox says
nothing and takes its default.

## Bad
```yaml
robot_model_type: "nav2_amcl::DiferentialMotionModel"
```

## Good
```yaml
robot_model_type: "nav2_amcl::DifferentialMotionModel"
```

## When to ignore it
When a plugin of your own has this name.

## References
- slam_toolbox, ceres_solver.cpp; navigation2, amcl_node.cpp, map_mode.cpp, velocity_smoother.cpp, polygon.cpp
- teleop_tools, joy_teleop.py; ros_gz, bridge_config.cpp; sensor_msgs, distortion_models.hpp
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import fix
from bringup_lint.api import rule


@rule(
    "warning",
    fix="unsafe",
    symptoms=["Invalid feedback_type, options are OPEN_LOOP and CLOSED_LOOP.", "Unknown action type: *"],
)
def word_misspelt(robot: Robot) -> Iterator[Finding]:
    for each in robot.misspelt_words:
        yield finding(
            each.value,
            f"{each.name} cannot be '{each.value}': {each.effect}",
            advice=f"write {each.meant}",
            fix=fix(f"write {each.meant}", (each.value, each.meant), safe=False),
            severity="error" if each.ends else None,
        )
