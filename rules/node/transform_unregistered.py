"""A tf2 buffer is given a message that nothing has registered.

## What it finds
In Python programs, `transform()` of a `tf2_ros.Buffer` with a `PointStamped`, `PoseStamped`,
`PoseWithCovarianceStamped` or `Vector3Stamped`, when neither the program nor a file of the tree that it imports
imports `tf2_geometry_msgs`; the same for a `PointCloud2` and `tf2_sensor_msgs`. Silent where the program imports a
library that may do so itself.

## Why it matters on a robot
`tf2_ros` knows no message: the import of `tf2_geometry_msgs` registers how they are turned. Without it each call
raises `TypeException`, which is no `TransformException`: the `except` that waits for a missing transform does not take
it, and the node ends with the first message.

## Bad
```python
from tf2_ros import Buffer

pose = self.buffer.transform(pose, 'base_link')
```

## Good
```python
import tf2_geometry_msgs  # registers the messages
from tf2_ros import Buffer

pose = self.buffer.transform(pose, 'base_link')
```

## When to ignore it
When something registers the type with `TransformRegistration` by itself.

## References
- tf2_ros_py, buffer_interface.py: `TransformRegistration`, `TypeException`
- https://docs.ros.org/en/jazzy/p/tf2_geometry_msgs/
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import nodes
from bringup_lint.api import rule


@rule("error", symptoms=["TypeException: Type * if not loaded or supported"])
def transform_unregistered(robot: Robot) -> Iterator[Finding]:
    for found in nodes.unregistered_types(robot.nodes):
        yield finding(
            found.file.span_of(found.call),
            f"Nothing imports {found.module}, so the buffer cannot turn a {found.type.rpartition('/')[2]}: "
            f"TypeException, and {found.end}",
            advice=f"import {found.module} in this program",
            severity=robot.nodes.lowered_if_vendored(found.file.source, "error"),
        )
