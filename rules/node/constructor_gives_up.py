"""The constructor of a node gives up, and the process goes on.

## What it finds
A `return` in the constructor of a node, after an error is logged, at which the node has neither a timer nor a topic nor
a service yet. Silent where only an argument of a Python constructor decides, where the branch shuts down, throws, exits
or sets something that others ask for, and where anything that may run later was made before. Info for a component that
launch files load into a container, and where the value of a parameter alone decides: with a wrong value the next start
would end in the same way. What a function makes of a parameter, as a device that it opens, is none.

## Why it matters on a robot
The device was not there yet, or a file is missing: the node logs one line and stays. `spin()` waits for callbacks that
do not exist. The process is alive, `ros2 node list` shows it, and so `respawn`, `Restart=on-failure` and `on_exit` do
nothing. When the device appears a second later, nobody tries again.

## Bad
```cpp
Lidar() : Node("lidar") {
  if (!port_.open("/dev/lidar")) { RCLCPP_ERROR(get_logger(), "no lidar"); return; }
  timer_ = create_wall_timer(100ms, [this] { read(); });
}
```

## Good
```cpp
Lidar() : Node("lidar") {
  if (!port_.open("/dev/lidar")) { throw std::runtime_error("no lidar"); }
  timer_ = create_wall_timer(100ms, [this] { read(); });
}
```

## When to ignore it
When somebody watches the topics of the node, and starts it again.

## References
- launch, execute_process.py: `respawn` and `on_exit` begin with the end of the process
- systemd.service(5), `Restart=`
- rclcpp, executor.cpp: `spin()` returns only when the context is shut down
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import Source
from bringup_lint.api import finding
from bringup_lint.api import nodes
from bringup_lint.api import note
from bringup_lint.api import regex
from bringup_lint.api import rule

REGISTERED = regex(r"\bRCLCPP_COMPONENTS_REGISTER_NODE\b", hints="RCLCPP_COMPONENTS_REGISTER_NODE")
MADE = "make_shared"
MAIN = regex(r"\bint[ \t\n]+main[ \t]*\(", hints="main")


@rule("warning", silent="the node logs an error of its own words, and stays in the list of nodes")
def constructor_gives_up(robot: Robot) -> Iterator[Finding]:
    for found in nodes.given_up(robot.nodes):
        source = found.left.source
        raised = "raise RuntimeError(...)" if source.name.endswith(".py") else "throw std::runtime_error(...)"
        lowest = found.is_setting or is_component(robot, source, found.owner)
        end = "so that neither respawn nor Restart= starts it again"
        yield finding(
            found.left,
            f"After this error {found.owner} has no timer, topic or service: the process stays alive and does nothing, "
            f"{'as if it were well' if found.is_setting else end}",
            advice=f"{raised} here, so that the process ends with a failure",
            related=[note(found.lost, "never reached then")],
            severity="info" if lowest else robot.nodes.lowered(source, "warning"),
        )


def is_component(robot: Robot, source: Source, name: str) -> bool:
    """Whether launch files load the node into a container of components, whose process a failure does not end, and no
    program makes it."""
    if not source.matches(REGISTERED) or any(
        MADE in each.text and f"{name}>" in each.text for each in _programs(robot)
    ):
        return False
    return any(f"::{name}" in each.text for each in robot.of_kind("launch-python", "launch-xml", "launch-yaml"))


def _programs(robot: Robot) -> Iterator[Source]:
    return (each for each in robot.of_kind("cpp-node") if each.matches(MAIN))
