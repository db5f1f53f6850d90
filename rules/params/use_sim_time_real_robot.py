"""A real robot waits for a simulated clock.

## What it finds
`use_sim_time: true` in a file that the bring-up of a robot loads. Reported only when everything that the launch file
starts is known, and none of it simulates or sets the parameter again. Files for simulation, tests and recordings are
not reported. It is an error for the nodes of Nav2, robot_localization and slam_toolbox, and for those whose
source in the tree has timers in ROS time. Other nodes may do without that time: it is a warning, and an info when
their source in the tree never asks for the time.

## Why it matters on a robot
Nothing publishes /clock: the time stays at zero, and timers never fire. The nodes run and do nothing.

## Bad
```yaml
/**:
  ros__parameters:
    use_sim_time: true
```

## Good
```yaml
/**:
  ros__parameters:
    use_sim_time: false
```

## When to ignore it
When a program outside this tree publishes /clock on the robot, for example a hardware-in-the-loop bench.

## References
- https://github.com/ros2/rclcpp/issues/940
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import fix
from bringup_lint.api import launch
from bringup_lint.api import note
from bringup_lint.api import regex
from bringup_lint.api import rule
from bringup_lint.api.launch import Started
from bringup_lint.api.params import simulated
from bringup_lint.api.params import waits_for_time

TIMERS = regex(r"\bcreate_(?:timer|rate)\s*\(|\bget_clock\(\)\s*(?:\.|->)\s*sleep_")
NOW = regex(r"(?<!::)\bnow\s*\(\)")
"""The ROS time, and not that of a clock of C++."""
LOOKED_UP = "and the transforms that it asks for are the newest ones, however old they are"
LOOKUP = regex(r"\b(?:lookup|can)_?[tT]ransform\w*\s*\(", hints="ransform")


@rule("error", fix="unsafe", symptoms=["No clock received, using time argument instead!"])
def use_sim_time_real_robot(robot: Robot) -> Iterator[Finding]:
    for found in simulated(robot.params):
        node = found.load.node
        texts = _texts(robot, node, node.label())
        program = texts or _texts(robot, node, launch.literal_text(node.executable) or node.label())
        looks_up = _only_looks_up(program)
        yield finding(
            found.parameter.span,
            f"Nothing publishes /clock on the robot: the ROS time of {found.load.node.label()} stays at zero, "
            + (LOOKED_UP if looks_up else "in its stamps and in all that waits for that time"),
            advice="write false, and let the node look up transforms with a timeout" if looks_up else "write false",
            related=[note(found.load.node.span, "gets the value here")],
            chain=robot.provenance.chain_to_load(found.load, note(found.parameter.span, "the node waits for /clock")),
            fix=fix("write false", (found.parameter.span, "false"), safe=False),
            severity=_severity(robot, found.load.node, texts),
        )


def _severity(robot: Robot, node: Started, texts: list[str]) -> str | None:
    """By what is known of the node: whether it surely waits for the ROS time, and whether it asks for it at all."""
    name = launch.literal_text(node.package) or ""
    if name not in robot.launch.workspace.packages:
        return None if waits_for_time(name) else "warning"
    if any(map(TIMERS.search, texts)):
        return None
    return "warning" if not texts or any(map(NOW.search, texts)) else "info"


def _texts(robot: Robot, node: Started, name: str) -> list[str]:
    """The sources of the node's package that hold a name, or are called so."""
    package = robot.launch.workspace.packages.get(launch.literal_text(node.package) or "")
    sources = robot.files.of_kind("python-node", "cpp-node") if package is not None else []
    own = (each for each in sources if robot.launch.workspace.owner(each) is package)
    return [each.text for each in own if name in each.text or each.basename.partition(".")[0] == name]


def _only_looks_up(texts: list[str]) -> bool:
    """Whether the node asks for the ROS time for transforms alone, where zero means the newest one."""
    asking = [line for text in texts for line in text.splitlines() if NOW.search(line)]
    return bool(asking) and all(map(LOOKUP.search, asking)) and not any(map(TIMERS.search, texts))
