"""A quaternion with its numbers in the wrong order.

## What it finds
In Python nodes, quaternions of `transforms3d` whose first number becomes `x` of a message, and those of
`tf_transformations` whose first number becomes `w`; and the four fields of a message that `quat2euler()`,
`euler_from_quaternion()` and the like get in the order of the other library.

## Why it matters on a robot
`transforms3d` has w first, messages and `tf_transformations` have it last. The result is a valid quaternion of another
orientation: without any rotation it is half a turn around x. Nothing reports it. The robot turns the wrong way, the
filter fuses a heading that nothing has measured, the arm goes to another pose.

## Bad
```python
q = transforms3d.euler.euler2quat(0.0, 0.0, yaw)
pose.orientation.x, pose.orientation.y, pose.orientation.z, pose.orientation.w = q
```

## Good
```python
w, x, y, z = transforms3d.euler.euler2quat(0.0, 0.0, yaw)
pose.orientation = Quaternion(x=x, y=y, z=z, w=w)
```

## When to ignore it
When a module of your own has the name of the library.

## References
- https://matthew-brett.github.io/transforms3d/reference/transforms3d.quaternions.html
- https://github.com/DLu/tf_transformations
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import nodes
from bringup_lint.api import note
from bringup_lint.api import rule


@rule("error", silent="every four numbers of this length are an orientation")
def quaternion_order(robot: Robot) -> Iterator[Finding]:
    for file in robot.nodes.judged:
        found = list(nodes.misordered_quaternions(robot.nodes.syntax(file)))
        if not found:
            continue
        first, *others = found
        yield finding(
            file.span_of(first.place),
            f"{first.function}() has the order {first.order}, and here it is {first.found}: "
            "this is another orientation",
            advice=f"write the numbers in the order {', '.join(first.order)}",
            related=[note(file.span_of(each.place), "here, too") for each in others[:10]],
            severity=robot.nodes.lowered(file.source, "error"),
        )
