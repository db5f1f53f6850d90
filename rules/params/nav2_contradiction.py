"""Values of Navigation2 that a server refuses, or that contradict each other.

## What it finds
In parameter files that something names: a `footprint` of a costmap that is no polygon, or has the same corner twice in
a row; an `inflation_radius` below the inscribed radius of the robot; `observation_sources` of an obstacle layer without
a section of their own, where no other file knows the name; a source that marks farther away than it clears; a layer
with `clearing: false` whose sources all mark, and none of which clears; limits of `velocity_smoother` with the wrong
sign, not one for each axis, or of zero for turning both ways; `polygons` of the collision monitor without a section;
`min_particles` of amcl above `max_particles`; an `initial_pose` without `set_initial_pose`; from Humble on the names
that amcl's motion models had before, and a section `recoveries_server` where one for `behavior_server` is missing or
lacks frames and speeds of it, or `default_bt_xml_filename`; a local costmap that rolls in the frame that amcl corrects;
critics that DWB or MPPI do not have, and critics of which none looks at obstacles; limits of `velocity_smoother` below
those that a controller of the same file plans with; a tree for `NavigateToPose` as that for `NavigateThroughPoses`, or
the reverse; zones of the collision monitor inside of the robot; a `robot_radius` of the local costmap far from that of
the global one; a `model_dt` of MPPI below the period of its server; a `data_type` that obstacle layers do not take; and
from Jazzy on libraries in `plugin_lib_names` that bt_navigator loads by itself. Layers with `enabled: false` are left
alone.

## Why it matters on a robot
A footprint that is refused leaves the robot with its radius, and the costmap lets it drive into what the corners touch.
With inflation below the inscribed radius, the planner goes along walls where the robot does not fit. An obstacle beyond
the range of clearing stays in the costmap after it left. In the frame of the map, every correction of amcl moves the
robot against the obstacles that it has seen. Without `set_initial_pose`, amcl waits for a pose and publishes no
transform. A limit of the wrong sign or length, a polygon without a type, an old motion model, or a library that
registers its nodes twice ends the server when it configures, and the lifecycle manager takes the whole navigation down.
A smoother that is slower than the controller makes another motion than the one that the controller found free.
`NavigateThroughPoses` sets `goals` and not `goal`, so that the tree of the other action fails. A zone inside of the
robot stops it after the collision. A section that no node reads leaves the recoveries with the frames, speeds and
plugins of the source.

## Bad
```yaml
velocity_smoother:
  ros__parameters:
    max_decel: [2.0, 0.0, 3.0]
```

## Good
```yaml
velocity_smoother:
  ros__parameters:
    max_decel: [-2.0, 0.0, -3.0]
```

## When to ignore it
When a launch file writes another value over the one in the file.

## References
- navigation2, array_parser.cpp, footprint.cpp, inflation_layer.cpp, obstacle_layer.cpp, velocity_smoother.cpp,
  collision_monitor_node.cpp, amcl_node.cpp, bt_navigator.cpp
- https://docs.nav2.org/migration/Galactic.html (Galactic to Humble: "Recovery Behavior Server Renamed")
- https://docs.nav2.org/migration/Iron.html (Iron to Jazzy: standard libraries are loaded by default)
- https://docs.nav2.org/configuration/
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import note
from bringup_lint.api import rule
from bringup_lint.api.params import NavigationProblem
from bringup_lint.api.params import navigation_problems

_ENDS = ("sign", "length", "polygon", "model", "footprint", "library", "critic", "type", "step")
"""What a server refuses."""


@rule(
    "warning",
    symptoms=[
        "The footprint parameter is invalid",
        "is smaller than the computed inscribed radius",
        "Positive values set of deceleration",
        "Negative values set of acceleration",
        "Invalid setting of kinematic and/or deadband limits!",
        "You've set min_particles to be greater than max particles",
        "ID [*] already registered",
        "Error while getting polygon parameters",
        "Positive values set of min_velocities",
        "Negative values set of max_velocities",
        "Invalid size of parameter *. Must be size",
        "Controller period more then model dt, set it equal to model dt",
        "Only topics that use point cloud2s or laser scans are currently supported",
        "with base class type dwb_core::TrajectoryCritic does not exist",
        "with base class type mppi::critics::CriticFunction does not exist",
    ],
)
def nav2_contradiction(robot: Robot) -> Iterator[Finding]:
    for each in navigation_problems(robot.params):
        yield finding(
            each.where,
            _message(each),
            advice=_advice(each),
            related=[note(each.other, "compared with this")] if each.other is not None else [],
            severity="error" if each.kind in _ENDS else None,
        )


def _message(each: NavigationProblem) -> str:
    match each.kind:
        case "footprint":
            return f"The footprint is refused, {each.detail}: the costmap takes robot_radius instead"
        case "corner":
            return f"The footprint has a corner twice in a row ({each.detail}): a part of the robot is outside of it"
        case "inflation":
            return f"The inflation radius is below the inscribed radius of {each.detail} m: paths touch obstacles"
        case "inflation-logged":
            return f"The inflation radius is below the inscribed radius of {each.detail} m: Nav2 logs an error"
        case "ranges":
            return f"'{each.name}' clears less far than it marks ({each.detail}): obstacles beyond stay in the costmap"
        case "source":
            return f"The source '{each.name}' of {each.detail} has no section: the layer reads the topic '{each.name}'"
        case "sign":
            return f"{each.name} has the wrong sign ({each.detail}): the velocity smoother refuses it, or never stops"
        case "length":
            return f"{each.name} has {each.detail}: the velocity smoother ends when it configures"
        case "turn":
            return f"{each.name} and min_velocity are 0 for theta: the velocity smoother takes every turn away"
        case "slower":
            return f"The velocity smoother drives slower than the controller plans ({each.detail})"
        case "tree":
            return f"The tree is that of the other action: it reads {each.detail}: each goal fails"
        case "old-tree":
            return f"bt_navigator reads no {each.name} since Galactic: it takes the tree of its own package"
        case "zone":
            return f"The robot itself fills {each.name} (radius {each.detail}): what is seen there has touched it"
        case "radii":
            return f"The costmaps are for robots of two sizes ({each.detail}): what one lets through, the other blocks"
        case "step":
            return f"The step of {each.name} is below the period of its server ({each.detail}): MPPI does not configure"
        case "blind":
            return f"No critic of {each.name} looks at the costmap: the controller drives into obstacles"
        case "polygon":
            return f"The polygon '{each.name}' has no section with a type: {each.detail} does not configure"
        case "pose":
            return f"{each.name} has no effect without set_initial_pose: amcl waits until something sends a pose"
        case "particles":
            return f"min_particles is above max_particles ({each.detail}): amcl raises the maximum"
        case "frame":
            return (
                f"The local costmap rolls in {each.detail}: each correction of amcl moves its obstacles off the robot"
            )
        case "section":
            return f"No node is called {each.name} since Humble: {each.detail} runs with the defaults of its source"
        case "halves":
            return f"No node is called {each.name} since Humble, and behavior_server lacks its {each.detail}"
        case "critic":
            return f"No critic is called '{each.name}': the controller server ends when it configures"
        case "type":
            return f"The source '{each.name}' is a {each.detail}: the costmap takes LaserScan and PointCloud2, and ends"
        case "clearing":
            return f"No source of {each.name} clears ({each.detail}): what it marked stays there after it left"
        case "library":
            return f"bt_navigator loads {each.name}{each.detail} by itself: it ends when it registers their nodes again"
    return f"amcl has no motion model '{each.name}' since Humble: it ends when it configures"


def _advice(each: NavigationProblem) -> str:
    match each.kind:
        case "footprint":
            return 'write "[[x, y], [x, y], [x, y]]" with the corners in metres'
        case "corner":
            return "write every corner once, in order around the robot"
        case "inflation":
            return "inflate by more than the inscribed radius"
        case "ranges":
            return "set raytrace_max_range above obstacle_max_range"
        case "source":
            return f"add a section {each.name} with topic and data_type, or take it off the list"
        case "sign":
            return (
                "write 0 or positive numbers"
                if each.name.startswith("max_") and "decel" not in each.name
                else ("write 0 or negative numbers")
            )
        case "length":
            return "write one number for each axis: x, y and theta"
        case "turn":
            return "write the speeds at which the robot may turn, in rad/s"
        case "slower":
            return "give both the same limit"
        case "tree":
            return f"write the tree of its own action, or leave out {each.name}"
        case "old-tree":
            return "write the path of the tree as default_nav_to_pose_bt_xml, or remove the line"
        case "zone":
            return "make the zone larger than the robot, by the distance that it needs to stop"
        case "radii":
            return "give both costmaps the same robot_radius"
        case "step":
            return "set model_dt to 1 / controller_frequency"
        case "blind":
            return f"add {each.detail.replace(', ', ' or ')}"
        case "polygon":
            return f"add a section {each.name}, or write the name of the one that is there"
        case "pose":
            return "add set_initial_pose: true"
        case "particles":
            return "swap the numbers"
        case "frame":
            return "write odom"
        case "section":
            return f"call it {each.detail}, recovery_plugins behavior_plugins, and the plugins nav2_behaviors/..."
        case "halves":
            return f"move them to behavior_server, and remove {each.name}"
        case "critic":
            return f"write {each.detail}" if each.detail else "write the name of a critic of this controller"
        case "type":
            return "write LaserScan or PointCloud2"
        case "clearing":
            return "set clearing: true for the source that sees where nothing is"
        case "library":
            return "list libraries of your own only, or remove plugin_lib_names"
    return f"write {each.detail}"
