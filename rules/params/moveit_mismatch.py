"""MoveIt is configured for a group or a controller that the robot does not have.

## What it finds
- In `kinematics.yaml`: solvers for groups that no SRDF of the package has, where no group of the SRDF has one.
- In `ompl_planning.yaml`: planners for groups of which the robot has none, as in a file that comes from another robot.
- In `moveit_controllers.yaml`: names in `controller_names` that have no section, or that are named nowhere else in the
  tree, where a parameter file gives the same joints to a trajectory controller of another name; an `action_ns` that the
  controller of that name in the same folder does not serve: trajectory controllers serve `follow_joint_trajectory`,
  gripper controllers `gripper_cmd`; sections of listed controllers without an `action_ns`. Also fewer joints than the
  trajectory controller has in every file of the tree, without `allow_partial_joints_goal`.
- In an SRDF: links and joints of groups, chains, states and the like that the description of the tree with the same
  robot name does not have, where it has most of the names.
- A launch file that starts MoveIt with controllers in a namespace (`/arm/arm_controller`), and no controller manager
  there.

Silent where xacro makes the SRDF.

## Why it matters on a robot
MoveIt leaves unknown links and joints out of their group: a chain without its tip is an empty group.
Without a solver for its group, MoveIt plans no goal for a pose. A controller of another name never offers its action:
MoveIt waits for the server, gives up, and executes nothing. For a group without planners, OMPL takes its default,
whatever planner is asked for.

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
        "Cannot find planning configuration for group *. Will use defaults instead.",
        "Action client not connected to action server",
        "No action namespace specified for controller",
        "Joints on incoming trajectory don't match the controller joints.",
        "Unable to identify any set of controllers that can actuate the specified joints",
        "is not known to the URDF",
    ],
)
def moveit_mismatch(robot: Robot) -> Iterator[Finding]:
    for each in robot.plugins.moveit_problems:
        if each.kind == "group":
            message = f"The SRDF has no group '{each.name}': none of its groups has a kinematics solver"
        elif each.kind == "planners":
            message = (
                f"The robot has no group '{each.name}' or any other of this file: its groups get no planners of it"
            )
        elif each.kind == "section":
            message = f"'{each.name}' has no section with its type and joints: MoveIt leaves the controller out"
        elif each.kind == "no-action":
            message = f"'{each.name}' has no action_ns: MoveIt leaves the controller out and executes nothing on it"
        elif each.kind == "action":
            message = f"The controller serves '{each.near}', not '{each.name}': MoveIt waits and executes nothing"
        elif each.kind == "joints":
            sent, had = (each.near or "").split()
            message = f"MoveIt sends {sent} joints to {each.name}, which has {had}: it rejects every goal"
        else:
            message = f"No controller is called '{each.name}': MoveIt waits for its action and executes nothing"
        yield finding(
            each.name,
            message,
            advice=_advice(each),
            related=list(_known(each)),
            severity="warning" if each.kind in ("action", "planners") else None,
        )
    for unknown in robot.plugins.unknown_srdf_names:
        yield finding(
            unknown.name,
            f"The robot has no {unknown.kind} '{unknown.name}': MoveIt leaves it out",
            advice=f"write {unknown.near}" if unknown.near else f"name a {unknown.kind} of the description",
            related=[
                note(unknown.described, "the description of the robot"),
                *(note(each, "not in it either") for each in unknown.others[:5]),
            ],
        )
    for away in robot.plugins.controllers_elsewhere:
        first, *others = away.names
        yield finding(
            away.manager.span,
            f"MoveIt sends to '{first}', and no controller manager runs in that namespace: "
            "MoveIt waits for its action and executes nothing",
            advice="start the controller manager in the namespace, or give MoveIt the names without it",
            related=[note(each, "MoveIt sends to this name") for each in (first, *others[:5])],
            chain=robot.provenance.chain_to_node(away.manager),
        )


def _advice(each: MoveItProblem) -> str:
    if each.kind == "joints":
        return "give both the same joints, or set allow_partial_joints_goal to true"
    if each.kind == "section":
        return f"write {each.near}" if each.near else f"add a section {each.name}, or take it off the list"
    if each.kind == "no-action":
        return f"write action_ns instead of {each.near}" if each.near else "add the action that the controller serves"
    return f"write {each.near}" if each.near else "name a group of the robot"


def _known(each: MoveItProblem) -> Iterator[Related]:
    told = {
        "group": "the SRDF has {}",
        "planners": "the robot has {}",
        "controller": "{} has these joints",
        "action": "its type is {}",
        "joints": "the joints of {}",
    }
    for name in each.known[:3]:
        yield note(name, told[each.kind].format(name))
