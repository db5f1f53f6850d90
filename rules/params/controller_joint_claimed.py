"""Two controllers that are activated together command the same joint.

## What it finds
Two controllers of one parameter file that claim the same interface of a joint, where a launch file spawns both without
`--inactive`: trajectory, forward command, gripper and PID controllers, and the wheels of diff_drive_controller, which
is given `pid_controller/wheel_joint` where a PID controller has the joint. It is an info where the launch files of a
configuration of MoveIt spawn them for the made-up hardware of its demo.

## Why it matters on a robot
A command interface belongs to one controller. The controller manager refuses to activate the second one ("already
claimed"): its arm or wheel does not move. A list of joints that was copied from the other side is the usual cause.

## Bad
```yaml
right_gripper_controller:
  ros__parameters:
    joints: [left_finger_joint]     # left_gripper_controller has it, too
```

## Good
```yaml
right_gripper_controller:
  ros__parameters:
    joints: [right_finger_joint]
```

## When to ignore it
When something deactivates the first controller before the second one is spawned.

## References
- ros2_control, controller_manager.cpp: "Resource conflict for controller"
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import note
from bringup_lint.api import rule


@rule("error", symptoms=["Resource conflict for controller", "already claimed"])
def controller_joint_claimed(robot: Robot) -> Iterator[Finding]:
    for claim in robot.plugins.claims:
        yield finding(
            claim.where,
            f"{claim.first} claims '{claim.joint}' as well: {claim.controller} is not activated",
            advice="give each controller its own joints, or spawn one of them with --inactive",
            related=[
                note(claim.before, f"the joints of {claim.first}"),
                note(claim.spawned, f"{claim.controller} is spawned here"),
            ],
            severity="info" if claim.is_mocked else None,
        )
