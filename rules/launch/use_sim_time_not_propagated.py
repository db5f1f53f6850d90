"""Some nodes use the simulated clock and others do not.

## What it finds
Launch files that give the argument `use_sim_time` to some of their nodes. Other nodes that depend on time
(localisation, mapping, planning, control, robot state) get neither the argument nor a parameter file, or a parameter
with nearly that name. Silent for robot_state_publisher, which takes the time of the joint states.

## Why it matters on a robot
In a simulation, or when a recording is replayed, half of the nodes use another time. Transforms are too old or in
the future, and every message is dropped.

## Bad
```python
Node(package='robot_localization', executable='ekf_node', parameters=[{'use_sim_time': use_sim_time}]),
Node(package='slam_toolbox', executable='async_slam_toolbox_node'),
```

## Good
```python
SetParameter(name='use_sim_time', value=use_sim_time),
Node(package='robot_localization', executable='ekf_node'),
Node(package='slam_toolbox', executable='async_slam_toolbox_node'),
```

## When to ignore it
When the node must keep the wall clock, for example because it talks to real hardware during a replay.

## References
- ROS 2 design, "Clock and Time"
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Fix
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import fix
from bringup_lint.api import launch
from bringup_lint.api import note
from bringup_lint.api import rule
from bringup_lint.api.python import Import
from bringup_lint.api.python import with_item
from bringup_lint.api.spelling import nearest

TIMED = ("localization", "mapping", "planning", "control", "costmap", "map", "state")


@rule(
    "warning",
    fix="unsafe",
    symptoms=[
        "the timestamp on the message is earlier than all the data in the transform cache",
        "Lookup would require extrapolation into the",
    ],
)
def use_sim_time_not_propagated(robot: Robot) -> Iterator[Finding]:
    for file in robot.launch.judged:
        own = [
            node
            for node in robot.launch.expansion(file).nodes
            if node.file is file and hasattr(node.action, "parameters")
        ]
        given = [node for node in own if any(reads(source) for source in getattr(node.action, "parameters", ()))]
        if not given:
            continue
        for node in own:
            inline = all(isinstance(source, launch.DictValue) and not source.open for source in node.parameters)
            if robot.launch.role(node).role not in TIMED or not inline or launch.setting(node, "use_sim_time").value:
                continue
            if any("use_sim_time" in (launch.text_of(word) or "") for word in node.arguments):
                continue
            if launch.literal_text(node.executable) == "static_transform_publisher" or chosen_by_clock(node):
                continue
            typo = misspelt(node)
            if typo is None and copies_stamps(node):
                continue
            why = f": '{typo}' is another parameter" if typo is not None else ""
            yield finding(
                node.span,
                f"{node.label()} keeps the wall clock while other nodes of the file follow use_sim_time{why}",
                advice="set the parameter once for all nodes with SetParameter"
                if typo is None
                else "write use_sim_time",
                related=[note(given[0].span, "this node gets it")],
                fix=pass_on(node, given[0]) if typo is None else None,
            )


def misspelt(node: launch.Started) -> str | None:
    """A parameter that the launch file gives the node and that is nearly called use_sim_time."""
    names = [name for key, _ in node.given if (name := launch.text_of(key)) is not None]
    return next(iter(nearest("use_sim_time", names)), None)


def pass_on(node: launch.Started, given: launch.Started) -> Fix | None:
    """Give the node the clock by the launch argument that gives it to another one, which reads one."""
    sources = getattr(given.action, "parameters", ())
    values = [source.get("use_sim_time") for source in sources if isinstance(source, launch.DictValue)]
    inner = (each for value in values if value is not None for each in launch.walk(value))
    name = next(each.name for each in inner if isinstance(each, launch.Argument))
    item = f"{{'use_sim_time': LaunchConfiguration('{name}')}}"
    change = with_item(node.span, "parameters", item, Import("launch.substitutions", "LaunchConfiguration"))
    return fix("pass use_sim_time to the node", codemod=change, safe=False) if change else None


def copies_stamps(node: launch.Started) -> bool:
    """Whether the transforms of a node get the time of the messages from which they come, whatever its own clock is."""
    return launch.literal_text(node.executable) == "robot_state_publisher"


def chosen_by_clock(node: launch.Started) -> bool:
    """Whether a condition ties the node to the use of simulated time: it then knows which clock runs."""
    return any(
        isinstance(each, launch.Argument) and "sim" in each.name
        for condition in node.conditions
        for each in launch.walk(condition.predicate)
    )


def reads(source: object) -> bool:
    value = source.get("use_sim_time") if isinstance(source, launch.DictValue) else None
    return value is not None and any(isinstance(each, launch.Argument) for each in launch.walk(value))
