"""Nothing reacts when a driver dies.

## What it finds
Nodes that drive hardware with neither `respawn` nor an exit action nor an `OnProcessExit` handler: known drivers, the
agent of micro-ROS, and programs of the workspace that open a port, bus or pin and publish measurements or take commands
to move, or that publish the odometry. Reported for launch files that also start other nodes, or that a unit launches. A
warning where a unit or container of the tree launches the file (not for odometry, of which a robot may have more than
one), where the same bring-up has another driver or controller restarted, or the file another node that is no tool, and
once a robot for `ros2_control_node` beside nodes that outlive it; else for information, and so for a node in a part
that an argument switches on, or that gets simulated time, and for `ros2_control_node` where nothing of the tree starts
controllers for it, or the package has its hardware from topic_based_ros2_control, and neither it nor a description
names other hardware: another node has the device there.

## Why it matters on a robot
If the driver ends, the launch continues and the service stays "active (running)": the robot is blind until somebody
looks. `ros2 launch` even exits with status 0, so `Restart=on-failure` of a unit never triggers.

## Bad
```python
Node(package='sllidar_ros2', executable='sllidar_node', name='lidar')
```

## Good
```python
Node(package='sllidar_ros2', executable='sllidar_node', name='lidar', on_exit=Shutdown())
```

## When to ignore it
When a watchdog outside of launch monitors the driver and acts, for example a diagnostics node that stops the robot
when its topic falls silent, or a device the robot can drive safely without.

## References
- https://github.com/ros2/launch/issues/174
- https://github.com/ros/ros_comm/issues/919
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Fix
from bringup_lint.api import NamedTuple
from bringup_lint.api import Related
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import fix
from bringup_lint.api import launch
from bringup_lint.api import note
from bringup_lint.api import regex
from bringup_lint.api import rule
from bringup_lint.api.python import Import
from bringup_lint.api.python import with_keyword
from bringup_lint.api.topics import device_role

WATCHED_ROLES = ("driver", "hardware")
COMMANDS = regex(
    r"\b(?:load|set|switch)_controller|\bcontroller_manager[ \t]{1,4}spawner\b",
    hints="load_controller set_controller switch_controller spawner",
)
"""What activates controllers without the spawner."""
TOPICS = "topic_based_ros2_control"
"""Hardware that only publishes commands and hears states: another node has the device."""
NO_DEVICES = {
    TOPICS,
    "fake_components",
    "gazebo_ros2_control",
    "gz_ros2_control",
    "ign_ros2_control",
    "mock_components",
    "transmission_interface",
}
"""Packages of hardware that is topics, a simulation or made up, and of what stands between hardware and joints."""
DEVICES = ("hardware", "driver", "arduino", "_ros2_control")
"""Parts of the names of packages that have hardware for ros2_control."""
ASIDE = ("tool", "state", "teleop", "container")


@rule("warning", fix="unsafe", silent="launch reports that a process has died, as for every process, and goes on")
def critical_no_required(robot: Robot) -> Iterator[Finding]:
    apart = []
    for expansion, node, role, supervised, restarted in unwatched(robot):
        missed = bool(restarted) or (supervised and role != "odometry")
        severity = None if missed and not is_option(node) and not has_simulated_time(node) else "info"
        if launch.is_manager(node) and not drives_hardware(robot, expansion):
            severity = "info"
        elif severity and is_whole_hardware(expansion, node):
            apart.append(node)
            continue
        name = "the micro-ROS agent" if role == "microcontroller" else node.label()
        effect = "a service around it stays active without its"
        if restarted and not supervised:
            effect = f"{restarted[0].label()} beside it is restarted, and runs on without the"
        yield finding(
            node.span,
            f"If {name} dies, the launch continues and nothing reacts: {effect} {role}",
            advice="set on_exit=Shutdown() and let the unit restart it with Restart=always, or set respawn",
            related=[
                *starts(robot, expansion.entry),
                *(note(each.span, "this one is restarted") for each in restarted[:1]),
            ],
            severity=severity,
            chain=robot.provenance.chain_to_node(node),
            fix=shut_down(node),
        )
    if apart:
        first, *others = {node.span: node for node in apart}.values()
        yield finding(
            first.span,
            f"If {first.label()} dies, the launch goes on without the hardware: nothing reacts, and the other nodes "
            "keep running",
            advice="set on_exit=Shutdown(), so that whoever starts the launch notices and starts it again",
            related=[note(each.span, "and here") for each in others[:9]],
            chain=robot.provenance.chain_to_node(first),
            fix=shut_down(first),
        )


class Unwatched(NamedTuple):
    """A program that drives hardware and whose end nothing handles."""

    expansion: launch.Expansion
    node: launch.Started
    role: str
    supervised: bool
    """Something starts the launch again when it ends."""
    restarted: list[launch.Started]
    """What launch restarts beside it."""


def unwatched(robot: Robot) -> Iterator[Unwatched]:
    for expansion in robot.launch.entries:
        entry = expansion.entry
        if robot.launch.simulated(entry):
            continue
        others = [node for node in expansion.nodes if robot.launch.role(node).role not in (*ASIDE, *WATCHED_ROLES)]
        starters = robot.runners.launching(entry)
        units = [each for each in starters if each.runner.unit is not None]
        supervised = any(robot.runners.is_supervised(each.runner) for each in starters)
        restarted = restarted_in(robot, expansion)
        seen = set()
        for node in expansion.nodes:
            if not isinstance(node.action, launch.Process) or node.by_default is False:
                continue
            if "respawn" in node.options or node.span in seen or launch.watched(node, expansion):
                continue
            beside = restarted_beside(robot, node, restarted)
            if not units and all(each.span == node.span for each in (*beside, *others)):
                continue
            role = device_role(robot.topics, node)
            if role is not None:
                seen.add(node.span)
                yield Unwatched(expansion, node, role, supervised, beside)


def restarted_in(robot: Robot, expansion: launch.Expansion) -> list[launch.Started]:
    """What launch restarts of a bring-up, but tools and the like."""
    return [
        each
        for each in expansion.nodes
        if each.by_default is not False and launch.respawns(each) and robot.launch.role(each).role not in ASIDE
    ]


def restarted_beside(robot: Robot, node: launch.Started, restarted: list[launch.Started]) -> list[launch.Started]:
    """The drivers and controllers of the same bring-up, and what else its own launch file starts, drivers first."""
    drives = {id(each): device_role(robot.topics, each) is not None for each in restarted}
    beside = [each for each in restarted if drives[id(each)] or each.file is node.file]
    return sorted(beside, key=lambda each: (each.file is not node.file, not drives[id(each)]))


def is_whole_hardware(expansion: launch.Expansion, node: launch.Started) -> bool:
    """Whether a launch file starts the controller manager beside nodes that outlive it."""
    if not launch.is_manager(node) or is_option(node):
        return False
    lasting = (each for each in expansion.nodes if each.is_node and each.by_default is True and each.span != node.span)
    return any(
        launch.literal_text(each.executable) not in (None, launch.SPAWNER, "create", launch.MANAGER) for each in lasting
    )


def drives_hardware(robot: Robot, expansion: launch.Expansion) -> bool:
    """Whether something starts controllers, and other than those of which the hardware is another node that hears their
    topics: those beside the manager, others apart from any, or commands."""
    if has_only_topics(robot, expansion):
        return False
    starts_some = expansion.opaque or launch.starts_controllers(expansion) or robot.mentions(COMMANDS)
    return starts_some or launch.has_controllers_apart(robot.launch)


def has_only_topics(robot: Robot, expansion: launch.Expansion) -> bool:
    """Whether the packages of a launch file depend on hardware that is topics, and neither they nor a description of
    the robot name another one that may have a device."""
    owners = (robot.launch.workspace.owner(each.source) for each in expansion.files)
    depends = {name for owner in owners if owner is not None for _, name in owner.manifest.depends}
    if TOPICS not in depends:
        return False
    named = {name for name in depends if any(part in name for part in DEVICES)}
    return named.union(each.partition("/")[0] for each in robot.plugins.described) <= NO_DEVICES


def shut_down(node: launch.Started) -> Fix | None:
    change = with_keyword(node.span, "on_exit", "Shutdown()", Import("launch.actions", "Shutdown"))
    return fix("shut down when it exits", codemod=change, safe=False) if change else None


def has_simulated_time(node: launch.Started) -> bool:
    """Whether the launch file itself gives a node the clock of a simulation."""
    given = {str(launch.literal_text(name)): launch.text_of(value) for name, value in node.given}
    return (given.get("use_sim_time") or "").lower() == "true"


def is_option(node: launch.Started) -> bool:
    """Whether a condition around the node, and none of its own, decides whether it starts."""
    return bool(node.conditions) and node.by_default is not True and not node.action.conditions


def starts(robot: Robot, entry: launch.LaunchFile) -> list[Related]:
    """The commands that launch the file, and the restart policies that do not see the end of a node."""
    related = []
    for command in robot.runners.launches:
        if command.file is entry and command.runner.unit is not None:
            policy = robot.units.restart(command.runner.unit)
            related.append(note(command.target, f"{command.runner.name} starts it"))
            if policy.restart in ("on-failure", "on-abnormal", "on-abort") and policy.restart_at is not None:
                related.append(note(policy.restart_at, "launch itself does not fail"))
    return related
