"""A parameter that the node does not declare.

## What it finds
Parameters in a parameter file or launch file for a node whose source is in the workspace and which declares none of
that name: no text of the source, or of the files that it includes or imports, is the name or a part of it. Nodes that
take undeclared parameters, or that build on classes which are not in the workspace, are left alone, and so are programs
of which a source is missing, and parameters that a launch file gives to several programs under one node name. Of
`joy_node`, `joy_linux_node` and `robot_state_publisher`, all parameters are known.

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

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import note
from bringup_lint.api import rule
from bringup_lint.api.launch import literal_text
from bringup_lint.api.params import undeclared
from bringup_lint.api.topics import LaunchedNode


@rule("warning", symptoms=["ParameterNotDeclaredException", "Parameter not set"])
def not_declared(robot: Robot) -> Iterator[Finding]:
    for found in undeclared(robot.topics):
        first, *others = found.given
        more = f" and {len(others)} other{'s' if len(others) > 1 else ''}" if others else ""
        yield finding(
            first.place,
            f"{_node(found.node)} declares no parameter '{first.name}'{more}: the value has no effect",
            advice="write the name that the source declares, or remove the value",
            related=[
                note(found.node.started.span, "the node is started here"),
                *(note(each.place, f"'{each.name}' is not declared either") for each in others[:10]),
            ],
            chain=robot.provenance.chain_to_node(found.node.started),
            confidence="medium",
        )


def _node(node: LaunchedNode) -> str:
    """The name of a node, and the program that it is."""
    program = literal_text(node.started.plugin) or literal_text(node.started.executable)
    package = literal_text(node.started.package)
    return f"{node.label()} ({program} of {package})" if program and package else node.label()
