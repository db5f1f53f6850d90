"""Values of Navigation2 that a server refuses, or that contradict each other.

## What it finds
In parameter files that something names: a `footprint` of a costmap that is no polygon, or has the same corner twice in
a row; an `inflation_radius` below the inscribed radius of the robot; `observation_sources` of an obstacle layer without
a section of their own, where no other file knows the name (an info beside sources that have one, unless a section of a
source is not on the list); a source that marks farther away than it clears; a layer with `clearing: false` whose
sources all mark, and none of which clears; limits of `velocity_smoother` with the wrong sign, not one for each axis, or
of zero for turning both ways; `polygons` of the collision monitor without a section; `min_particles` of amcl above
`max_particles`; an `initial_pose` without `set_initial_pose`; from Humble on the names that amcl's motion models had
before, and a section `recoveries_server` where one for `behavior_server` is missing or lacks frames and speeds of it,
or `default_bt_xml_filename`; a local costmap that rolls in the frame that amcl corrects; critics that DWB or MPPI do
not have, and critics of which none looks at obstacles; limits of `velocity_smoother` below those that a controller of
the same file plans with; a tree for `NavigateToPose` as that for `NavigateThroughPoses`, or the reverse; zones of the
collision monitor inside of the robot; a `robot_radius` of the local costmap far from that of the global one; a topic or
`robot_base_frame` of one costmap, or the scan of amcl, that nothing else of the robot names, where the other costmap
has another one that is named elsewhere; `allow_reversing` beside `use_rotate_to_heading` in Galactic and Humble; a
`model_dt` of MPPI below the period of its server; a `data_type` that obstacle layers do not take; and from Jazzy on
libraries in `plugin_lib_names` that bt_navigator loads by itself. A `default_bt_xml_filename` that names the tree which
Nav2 takes anyway is an info, and so is what ends no server in the files of tests. Layers with `enabled: false` are left
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
from bringup_lint.api import Purpose
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import note
from bringup_lint.api import rule
from bringup_lint.api.params import NavigationProblem
from bringup_lint.api.params import navigation_problems

_TEXTS: dict[str, tuple[str, str, str | None]] = {
    "footprint": (
        "The footprint is refused, {detail}: the costmap takes robot_radius instead",
        'write "[[x, y], [x, y], [x, y]]" with the corners in metres',
        "error",
    ),
    "corner": (
        "The footprint has a corner twice in a row ({detail}): a part of the robot is outside of it",
        "write every corner once, in order around the robot",
        None,
    ),
    "inflation": (
        "The inflation radius is below the inscribed radius of {detail} m: paths touch obstacles",
        "inflate by more than the inscribed radius",
        None,
    ),
    "inflation-logged": (
        "The inflation radius is below the inscribed radius of {detail} m: Nav2 logs an error",
        "inflate by {detail} m or more",
        None,
    ),
    "ranges": (
        "'{name}' clears less far than it marks ({detail}): obstacles beyond stay in the costmap",
        "set raytrace_max_range above obstacle_max_range",
        None,
    ),
    "source": (
        "The source '{name}' of {detail} has no section: the layer reads the topic '{name}'",
        "add a section {name} with topic and data_type, or take it off the list",
        None,
    ),
    "stray": (
        "The source '{name}' of {detail} has no section, as others have: the layer waits for a topic '{name}', too",
        "take it off the list, or add a section {name} with topic and data_type",
        "info",
    ),
    "unlisted": (
        "The source '{name}' has no section, and the section '{detail}' of its layer is not on the list: the layer "
        "reads the topic '{name}'",
        "correct the name: write the same one on the list and for the section",
        None,
    ),
    "sign": (
        "{name} has the wrong sign ({detail}): the velocity smoother refuses it, or never stops",
        "write 0 or {sign} numbers",
        "error",
    ),
    "length": (
        "{name} has {detail}: the velocity smoother ends when it configures",
        "write one number for each axis: x, y and theta",
        "error",
    ),
    "turn": (
        "{name} and min_velocity are 0 for theta: the velocity smoother takes every turn away",
        "write the speeds at which the robot may turn, in rad/s",
        None,
    ),
    "slower": (
        "The velocity smoother drives slower than the controller plans ({detail})",
        "give both the same limit",
        None,
    ),
    "tree": (
        "The tree is that of the other action: it reads {detail}: each goal fails",
        "write the tree of its own action, or leave out {name}",
        None,
    ),
    "old-tree": (
        "bt_navigator reads no {name} since Galactic: it takes the tree of its own package",
        "write the path of the tree as default_nav_to_pose_bt_xml, or remove the line",
        None,
    ),
    "zone": (
        "The robot itself fills {name} (radius {detail}): what is seen there has touched it",
        "make the zone larger than the robot, by the distance that it needs to stop",
        None,
    ),
    "radii": (
        "The costmaps are for robots of two sizes ({detail}): what one lets through, the other blocks",
        "give both costmaps the same robot_radius",
        None,
    ),
    "step": (
        "The step of {name} is below the period of its server ({detail}): MPPI does not configure",
        "set model_dt to 1 / controller_frequency",
        "error",
    ),
    "blind": (
        "No critic of {name} looks at the costmap: the controller drives into obstacles",
        "add {either}",
        None,
    ),
    "reversing": (
        "The controller turns {name} off, because {detail}: the robot never drives backwards",
        "set use_rotate_to_heading: false for the controller that reverses",
        None,
    ),
    "polygon": (
        "The polygon '{name}' has no section with a type: {detail} does not configure",
        "add a section {name}, or write the name of the one that is there",
        "error",
    ),
    "pose": (
        "{name} has no effect without set_initial_pose: amcl waits until something sends a pose",
        "add set_initial_pose: true",
        None,
    ),
    "particles": (
        "min_particles is above max_particles ({detail}): amcl raises the maximum",
        "swap the numbers",
        None,
    ),
    "frame": (
        "The local costmap rolls in {detail}: each correction of amcl moves its obstacles off the robot",
        "write odom",
        None,
    ),
    "beside": (
        "Nothing else of the robot names the topic {name}: nothing arrives there (a costmap takes {detail})",
        "write {detail}, or start what publishes {name}",
        None,
    ),
    "base": (
        "Nothing else of the robot names the frame {name}: the costmap waits for it (the other takes {detail})",
        "write {detail}",
        None,
    ),
    "section": (
        "No node is called {name} since Humble: {detail} runs with the defaults of its source",
        "call it {detail}, recovery_plugins behavior_plugins, and the plugins nav2_behaviors/...",
        None,
    ),
    "halves": (
        "No node is called {name} since Humble, and behavior_server lacks its {detail}",
        "move them to behavior_server, and remove {name}",
        None,
    ),
    "critic": (
        "No critic is called '{name}': the controller server ends when it configures",
        "write {critic}",
        "error",
    ),
    "type": (
        "The source '{name}' is a {detail}: the costmap takes LaserScan and PointCloud2, and ends",
        "write LaserScan or PointCloud2",
        "error",
    ),
    "clearing": (
        "No source of {name} clears ({detail}): what it marked stays there after it left",
        "set clearing: true for the source that sees where nothing is",
        None,
    ),
    "library": (
        "bt_navigator loads {name}{detail} by itself: it ends when it registers their nodes again",
        "list libraries of your own only, or remove plugin_lib_names",
        "error",
    ),
    "model": (
        "amcl has no motion model '{name}' since Humble: it ends when it configures",
        "write {detail}",
        "error",
    ),
}
"""Kind -> what happens, what to write instead, and the severity where a server ends."""

TREES = ("navigate_w_replanning_and_recovery.xml", "navigate_to_pose_w_replanning_and_recovery.xml")
"""What bt_navigator takes anyway, by its old and by its present name."""


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
        "Both use_rotate_to_heading and allow_reversing parameter cannot be set to true",
        "Controller period more then model dt, set it equal to model dt",
        "Only topics that use point cloud2s or laser scans are currently supported",
        "with base class type dwb_core::TrajectoryCritic does not exist",
        "with base class type mppi::critics::CriticFunction does not exist",
    ],
)
def nav2_contradiction(robot: Robot) -> Iterator[Finding]:
    for each in navigation_problems(robot.params):
        message, advice, severity = _TEXTS[each.kind]
        said = _said(each)
        yield finding(
            each.where,
            message.format(**said),
            advice=advice.format(**said),
            related=[note(each.other, "compared with this")] if each.other is not None else [],
            severity="info" if _is_harmless(robot, each, severity) else severity,
        )


def _is_harmless(robot: Robot, each: NavigationProblem, severity: str | None) -> bool:
    """Whether Nav2 does the same without the value, or only a test goes on in another way."""
    if each.kind == "old-tree" and each.detail.strip("\"'").endswith(TREES):
        return True
    return severity is None and robot.purpose(each.where) is Purpose.TEST


def _said(each: NavigationProblem) -> dict[str, str]:
    return {
        "name": each.name,
        "detail": each.detail,
        "either": each.detail.replace(", ", " or "),
        "critic": each.detail or "the name of a critic of this controller",
        "sign": "positive" if each.name.startswith("max_") and "decel" not in each.name else "negative",
    }
