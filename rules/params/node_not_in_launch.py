"""A block of parameters never reaches the node that it is for.

## What it finds
Node keys that are close to the name of a node that loads the file: a misspelling, or the right name in another
namespace. Another block of the file reaches that node. (If no block does, `params/file-key-mismatch` reports the
file.) Also a block for a node that a launch file starts beside the one that gets the file, without the file. Silent for
components, when a node's name or namespace is not known, and when something else mentions the
file.

## Why it matters on a robot
No message appears, unless the node declares a parameter without a default. The node runs with the defaults of its
code, and the tuned values are never used.

## Bad
```yaml
motor_controler:        # the node is called motor_controller
  ros__parameters:
    max_speed: 0.5
```

## Good
```yaml
motor_controller:
  ros__parameters:
    max_speed: 0.5
```

## When to ignore it
When the block is for a node that is started by hand or from another repository.

## References
- https://github.com/ros2/ros2/issues/569
- https://github.com/ros2/rcl/issues/954
- https://github.com/ros-navigation/navigation2/issues/3182
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import fix
from bringup_lint.api import note
from bringup_lint.api import rule
from bringup_lint.api.params import unhanded
from bringup_lint.api.params import unused


@rule("warning", fix="unsafe", symptoms=["ParameterUninitializedException: The parameter '*' is not initialized"])
def node_not_in_launch(robot: Robot) -> Iterator[Finding]:
    for found in unused(robot.topics):
        name = found.name.removeprefix("/")
        single = len(found.block.keys) == 1
        yield finding(
            found.block.key,
            f"No node is called '{found.block.name}' (there is {found.name}): these parameters are never used and the "
            "defaults stay",
            advice=f"write {name}",
            chain=robot.provenance.chain_to_load(
                found.load, note(found.block.key, f"the block is for {found.block.name}")
            ),
            related=[
                note(found.load.node.span, f"{found.name} is started here"),
                note(found.load.where, "loads the file here"),
            ],
            fix=fix(f"write {name}", (found.block.key, name), safe=False) if single else None,
        )
    for each in unhanded(robot.topics):
        others = [note(each.node.started.span, f"{each.node.label()} is started here")]
        yield finding(
            each.block.key,
            f"{each.node.label()} is started without this file: the parameters of its block are never used and the "
            "defaults stay",
            advice="give the file to this node, too (parameters=)",
            related=[*others, note(each.load.where, "only another node gets the file here")],
        )
