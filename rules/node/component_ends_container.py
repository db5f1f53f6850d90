"""A component or lifecycle node ends the whole process that it is loaded into.

## What it finds
`rclcpp::shutdown()`, `exit()`, `abort()` and the like in a method of a class that its file registers with
`RCLCPP_COMPONENTS_REGISTER_NODE`, and in transitions such as `on_configure()` of any class, or in a method of the file
that a transition calls. It is a warning in a transition, and where a launch file of the tree loads the component, else
an info. Once a class, with the other places.

## Why it matters on a robot
A component shares its process and its context with all nodes of the container. A camera that is not plugged in, or a
wrong parameter, ends the lidar driver and the controller beside it. What a component that cannot work should do is to
throw from its constructor: then only its own load fails, and the container says why. A transition that fails leaves
the node as it was, and whoever manages it can try again. What fails later is logged and tried again; where the process
is to end with it, the component belongs in a container of its own.

## Bad
```cpp
Camera::Camera(const rclcpp::NodeOptions & options) : Node("camera", options) {
  if (!open()) { rclcpp::shutdown(); return; }
}
```

## Good
```cpp
Camera::Camera(const rclcpp::NodeOptions & options) : Node("camera", options) {
  if (!open()) { throw std::runtime_error("no camera"); }
}
```

## When to ignore it
When the component always runs alone in its process, or the robot is to stop as a whole.

## References
- https://docs.ros.org/en/jazzy/Concepts/Intermediate/About-Composition.html
- rclcpp_components, component_manager.cpp: what a constructor throws becomes the answer to the load request
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import nodes
from bringup_lint.api import note
from bringup_lint.api import rule


@rule("warning", silent="the other nodes of the container end as if they had been told to")
def component_ends_container(robot: Robot) -> Iterator[Finding]:
    for (first, *others), loaded in nodes.ended_containers(robot.nodes):
        is_known = loaded is not None or first.step is not None
        scope = "every node of its container stops" if first.is_context else "its container ends with all its nodes"
        yield finding(
            first.place,
            f"{first.component} calls {first.call}(): {scope}"
            if first.step is None
            else f"{first.step}() calls {first.call}(): the process ends, and nobody can configure the node once more",
            advice=_advice(first),
            related=[
                *([note(loaded, "loaded here")] if loaded is not None else []),
                *(note(each.place, f"{each.call}() here too") for each in others),
            ],
            severity=robot.nodes.lowered_if_vendored(first.place.source, "warning") if is_known else "info",
        )


def _advice(end: nodes.ComponentEnd) -> str:
    if end.step is not None:
        return "return FAILURE from the transition"
    if end.is_made:
        return "throw an exception instead: then only this component fails to load"
    return "log it and try again, or load the component into a container of its own"
