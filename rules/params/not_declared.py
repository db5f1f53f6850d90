"""A parameter that the node does not declare.

## What it finds
Parameters in a parameter file or launch file for a node whose source is in the workspace and which declares none of
that name: where each declaration of its sources has its name written in the call, none has this one; else no text of
the source, or of the files that it includes or imports, is the name or a part of it. Nodes that take undeclared
parameters, or that build on classes which are not in the workspace, are left alone, and so are programs of which a
source is missing, and parameters that a launch file gives to several programs under one node name. All parameters are
known of `joy_node`, `joy_linux_node`, `robot_state_publisher`, `joint_state_publisher`, slam_toolbox,
robot_localization, twist_mux, teleop_twist_joy, usb_cam, pointcloud_to_laserscan, depthimage_to_laserscan, imu_tools,
rosbridge_suite, foxglove_bridge, topic_tools, cartographer_ros, web_video_server, apriltag_ros, explore_lite, the
drivers of common laser scanners (rplidar_ros, sllidar_ros2, ydlidar_ros2_driver, ldlidar_stl_ros2, livox_ros_driver2,
velodyne, urg_node), the servers of Navigation2, the controller manager and the controllers of ros2_controllers whose
class the file names; a block with the usual name of such a node is judged as its own. The controller manager hands
nothing of its block to a controller, whose parameters need a block of their own. A value that the launch file reads
itself is left alone, and so is what the controller manager gets from a file that a program of the tree reads itself;
one that a comment of the package calls unneeded is an info. In the sections of Navigation2's own plugins, a parameter
is unknown when nothing of Navigation2 has one whose name ends so. Packages whose repository the tree patches, or
fetches from others than its first owners, may be changed, and are left alone. Of `realsense2_camera`, names that newer
releases have changed, unless the tree is for a distribution that never got these, or fetches an older one.

Where it is not known which program gets a block, or the program declares whatever it is given: parameters that no
source of the tree names, when one source reads at least three others of the block, and most of them. Also those that
the file of a generate_parameter_library has not, in a block of the same name as its node. Both are an info where the
tree has launch files, nothing names the parameter file, and nothing puts such a name together or takes a whole folder.

## Why it matters on a robot
A node takes what it is given only for parameters that it declares; the rest is dropped without a word. A watchdog, a
limit of current or speed that the file sets is not one: the node goes on with the value in its code, if it has such a
limit at all.

## Bad
```yaml
drive:
  ros__parameters:
    cmd_timeout: 0.5   # drive.py declares command_timeout
```

## Good
```yaml
drive:
  ros__parameters:
    command_timeout: 0.5
```

## When to ignore it
When the parameter is for another version of the node.

## References
- https://docs.ros.org/en/jazzy/Concepts/Basic/About-Parameters.html
- rclcpp, node_parameters.cpp: overrides of parameters that are not declared
"""

from collections.abc import Iterator
from collections.abc import Sequence

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import note
from bringup_lint.api import rule
from bringup_lint.api.launch import literal_text
from bringup_lint.api.params import GoneParameters
from bringup_lint.api.params import Unknown
from bringup_lint.api.params import Unread
from bringup_lint.api.params import gone_parameters
from bringup_lint.api.params import is_left
from bringup_lint.api.params import undeclared
from bringup_lint.api.params import unknown_to_public
from bringup_lint.api.params import unlisted
from bringup_lint.api.params import unread
from bringup_lint.api.spelling import nearest
from bringup_lint.api.topics import LaunchedNode

COPY = "rs_launch.py"
"""A launch file of the package itself, of which many trees have a copy that nobody starts."""


@rule("warning", symptoms=["ParameterNotDeclaredException", "Parameter not set"])
def not_declared(robot: Robot) -> Iterator[Finding]:
    said = set()
    for found in undeclared(robot.topics):
        package = literal_text(found.node.started.package) or ""
        if package not in robot.launch.workspace.packages and robot.dependencies.is_forked(package):
            continue
        first, *others = found.given
        said |= {each.place.span for each in found.given}
        yield finding(
            first.place,
            f"{_node(found.node)} declares no parameter '{first.name}'{_more(others)}: the value has no effect",
            advice=_advice(robot, found.node),
            related=[
                note(found.node.started.span, "the node is started here"),
                *(note(each.place, f"'{each.name}' is not declared either") for each in others[:10]),
            ],
            chain=robot.provenance.chain_to_node(found.node.started),
            confidence="medium",
            severity="info" if found.is_unneeded else None,
        )
    lacking = (each for group in robot.plugins.incomplete_controllers for each in group)
    said |= {each.near.key.span for each in lacking if each.near is not None}
    for each in unknown_to_public(robot.params):
        is_said = bool(said & {parameter.key.span for parameter in each.parameters})
        if not is_said and not robot.dependencies.is_forked(each.node.package):
            said |= {parameter.key.span for parameter in each.parameters}
            yield _of_public(each)
    for renamed in gone_parameters(robot.topics):
        gone = renamed.given[0][1]
        if not robot.dependencies.is_kept_before(gone.package, gone.named):
            said |= {given.place.span for given, _ in renamed.given}
            yield _of_renamed(robot, renamed)
    for lost in (*unread(robot.params, robot.launch), *unlisted(robot.params, robot.launch)):
        if not said & {parameter.key.span for parameter in lost.parameters}:
            yield _of_reader(robot, lost)


def _advice(robot: Robot, node: LaunchedNode) -> str:
    words = robot.topics.parameter_words(node.started)
    if words is None or words.texts:
        return "write the name that the source declares, or remove the value"
    return "give the program its options with arguments=, or remove the value: it has no parameters"


def _of_public(found: Unknown) -> Finding:
    """A finding about a node of which no release has the parameters."""
    first, *others = found.parameters
    near = nearest(str(first.name), found.node.parameters, 3)
    return finding(
        first.key,
        f"{found.name} ({found.node.package}) declares no parameter '{first.name}'{_more(others)}: "
        "the value has no effect",
        advice=_advice_of_public(found.node.package, first.name, near),
        related=[note(each.key, f"'{each.name}' is not declared either") for each in others[:10]],
        confidence="medium",
    )


def _advice_of_public(package: str, name: str, near: Sequence[str]) -> str:
    if near:
        return f"write {near[0]}, or remove the value"
    controller, dot, _ = name.partition(".")
    if package == "controller_manager" and dot:
        return f"write it in the block of {controller} itself, or remove it: the controller manager hands nothing on"
    return "remove the value, or correct its name"


def _of_renamed(robot: Robot, found: GoneParameters) -> Finding:
    """A finding about parameters that a node of a public package had in older releases."""
    (first, gone), *others = found.given
    started = found.node.started
    return finding(
        first.place,
        f"{_node(found.node)} has no parameter '{first.name}'{_more(others)} in newer releases of {gone.package}: "
        "the value has no effect",
        advice=f"write {gone.now}",
        related=[
            note(started.span, "the node is started here"),
            *(note(given.place, f"write {each.now} for '{given.name}'") for given, each in others[:10]),
        ],
        chain=robot.provenance.chain_to_node(started),
        confidence="medium",
        severity="info" if first.place.span.source.basename == COPY else None,
    )


def _of_reader(robot: Robot, lost: Unread) -> Finding:
    """A finding about parameters that no source names, beside others that one reads."""
    first, *others = lost.parameters
    near = nearest(str(first.name), lost.names, 4)
    return finding(
        first.key,
        f"No source of the workspace reads '{first.name}'{_more(others)}: the value has no effect",
        advice=f"write {near[0]}, or remove the value" if near else "remove the value, or have the source read it",
        related=[
            note(lost.reader, f"{lost.read} other parameters of {lost.block.name} are read here"),
            *(note(each.key, f"'{each.name}' is not read either") for each in others[:10]),
        ],
        confidence="medium",
        severity="info" if is_left(robot.params, lost.file) else None,
    )


def _more(others: Sequence[object]) -> str:
    return f" and {len(others)} other{'s' if len(others) > 1 else ''}" if others else ""


def _node(node: LaunchedNode) -> str:
    """The name of a node, and the program that it is."""
    program = node.started.program
    package = literal_text(node.started.package)
    return f"{node.label()} ({program} of {package})" if program and package else node.label()
