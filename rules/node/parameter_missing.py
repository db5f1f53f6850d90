"""A parameter that the node needs and does not have.

## What it finds
A node that asks itself for a parameter which nothing in its program declares, and a launched node that declares a
parameter with a type but no default while no file and no launch file gives it a value. Calls under a condition, or
whose exception is handled, are left alone. Calls that answer false or a default instead, `get_parameter(name, value)`
of C++ and `get_parameter_or()`, are a warning, and so is a twist_mux in Jazzy or newer that is not given `use_stamped`.

## Why it matters on a robot
Both raise an exception: `ParameterNotDeclaredException`, or `ParameterUninitializedException`. The node ends at its
start, or in the middle of a drive when only a callback asks. twist_mux 4.4, which Jazzy and Kilted got in 2024, ends
with `could not load parameter 'use_stamped'`, and nothing drives the robot any more; the 4.3 of Humble has no such
parameter.

`get_parameter(name, value)` answers false without a word, and leaves `value` as it was: the number of the parameter
file is never used, and a switch that is documented cannot be switched.

## Bad
```python
self.declare_parameter('cmd_timeout', 0.5)
self.timeout = self.get_parameter('command_timeout').value
```

## Good
```python
self.declare_parameter('command_timeout', 0.5)
self.timeout = self.get_parameter('command_timeout').value
```

## When to ignore it
When another program declares the parameter in the node before it is asked for.

## References
- https://docs.ros.org/en/jazzy/Concepts/Basic/About-Parameters.html
- rclpy, node.py, get_parameter; rclcpp, node_parameters.cpp
- https://github.com/ros-teleop/twist_mux/issues/53
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Located
from bringup_lint.api import Robot
from bringup_lint.api import Source
from bringup_lint.api import finding
from bringup_lint.api import note
from bringup_lint.api import rule
from bringup_lint.api.nodes import asked_in_vain
from bringup_lint.api.nodes import asked_quietly
from bringup_lint.api.nodes import is_called_nowhere
from bringup_lint.api.nodes import switchless
from bringup_lint.api.nodes import unset


@rule(
    "error",
    symptoms=[
        "ParameterNotDeclaredException",
        "ParameterUninitializedException",
        "NoParameterOverride",
        "could not load parameter '*'",
    ],
)
def parameter_missing(robot: Robot) -> Iterator[Finding]:
    for name in asked_in_vain(robot.topics):
        yield finding(
            name,
            f"Nothing declares the parameter '{name}': the call raises ParameterNotDeclaredException",
            advice="declare the parameter with a default before it is asked for",
            severity="info"
            if is_called_nowhere(robot.topics, name.span)
            else robot.nodes.lowered(name.span.source, "error"),
            confidence="medium",
        )
    by_source: dict[Source, list[Located]] = {}
    for name in asked_quietly(robot.topics):
        by_source.setdefault(name.span.source, []).append(name)
    for source, (first, *others) in by_source.items():
        yield finding(
            first,
            f"Nothing declares the parameter '{first}': the call never gets a value, whatever a file or launch sets",
            advice="declare the parameter with a default before it is asked for",
            related=[note(each, f"nothing declares '{each}' either") for each in others],
            severity=robot.nodes.lowered_if_vendored(source, "warning"),
            confidence="medium",
        )
    for found in unset(robot.topics):
        yield finding(
            found.node.started.span,
            f"{found.node.label()} declares '{found.declared}' without a default, and nothing gives it: the node ends "
            "at its start",
            advice="give the parameter a value, or declare it with a default",
            related=[note(found.declared, "declared here")],
            chain=robot.provenance.chain_to_node(found.node.started),
            confidence="medium",
        )
    for each in switchless(robot.topics):
        if robot.dependencies.is_forked("twist_mux"):
            return
        yield finding(
            each.node.started.span,
            f"{each.node.label()} is not given '{each.parameter}': the releases of twist_mux for "
            f"{each.distribution.capitalize()} of 2024 and 2025 end at their start without it",
            advice=f"give it {each.parameter}: true for TwistStamped, or false for Twist",
            severity="warning",
            confidence="medium",
        )
