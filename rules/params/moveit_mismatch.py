"""MoveIt is configured for a group or a controller that the robot does not have.

## What it finds
- In `kinematics.yaml`: solvers for groups that no SRDF of the package has, where no group of the SRDF has one.
- In `moveit_controllers.yaml`: names in `controller_names` that are named nowhere else in the tree, where a parameter
  file gives the same joints to a trajectory controller of another name.

Silent where xacro makes the SRDF.

## Why it matters on a robot
Without a solver for its group, MoveIt plans no goal for a pose. A controller of another name never offers its action:
MoveIt waits for the server, gives up, and executes nothing.

## Bad
```yaml
manipulator:              # SRDF: <group name="arm">
  kinematics_solver: kdl_kinematics_plugin/KDLKinematicsPlugin
```

## Good
```yaml
arm:
  kinematics_solver: kdl_kinematics_plugin/KDLKinematicsPlugin
```

## When to ignore it
When the file is for another robot whose SRDF is not in the tree.

## References
- https://moveit.picknik.ai/main/doc/examples/kinematics_configuration/kinematics_configuration_tutorial.html
- moveit2, kinematics_plugin_loader.cpp and moveit_simple_controller_manager.cpp
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Related
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import note
from bringup_lint.api import rule
from bringup_lint.api.params import MoveItProblem


@rule(
    "error",
    symptoms=[
        "No kinematics plugins defined. Fill and load kinematics.yaml!",
        "Action client not connected to action server",
        "Unable to identify any set of controllers that can actuate the specified joints",
    ],
)
def moveit_mismatch(robot: Robot) -> Iterator[Finding]:
    for each in robot.plugins.moveit_problems:
        if each.kind == "group":
            message = f"The SRDF has no group '{each.name}': none of its groups has a kinematics solver"
        else:
            message = f"No controller is called '{each.name}': MoveIt waits for its action and executes nothing"
        yield finding(
            each.name,
            message,
            advice=f"write {each.near}" if each.near else "name a group of the SRDF",
            related=list(_known(each)),
        )


def _known(each: MoveItProblem) -> Iterator[Related]:
    for name in each.known[:3]:
        yield note(name, f"the SRDF has {name}" if each.kind == "group" else f"{name} has these joints")
