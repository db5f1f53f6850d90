"""A transform is looked up without handling that there is none.

## What it finds
`lookup_transform()` and `transform()` of a tf2 buffer in Python, and `lookupTransform()` in C++, in a callback of a
subscription, timer, service or client, when no `try` surrounds the call and `can_transform()` is not asked before. In
C++ only where the callback itself makes the call. Action servers of Python are left out: rclpy catches what their
callbacks raise.

## Why it matters on a robot
Each start begins without transforms, and each transform arrives after the sensor data that it belongs to. tf2 raises
LookupException, ConnectivityException or ExtrapolationException then. The exception leaves `spin()`, and the node
ends: usually with the first message, later whenever localization is late once.

## Bad
```python
def on_scan(self, scan):
    pose = self.buffer.lookup_transform('map', scan.header.frame_id, scan.header.stamp)
```

## Good
```python
def on_scan(self, scan):
    try:
        pose = self.buffer.lookup_transform('map', scan.header.frame_id, scan.header.stamp)
    except TransformException as error:
        self.get_logger().warning(f'no transform: {error}', throttle_duration_sec=5.0)
        return
```

## When to ignore it
When the node is meant to end, and what starts it starts it again.

## References
- https://docs.ros.org/en/jazzy/Tutorials/Intermediate/Tf2/Writing-A-Tf2-Listener-Py.html
- rclpy, executors.py: exceptions of callbacks are raised by spin()
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import nodes
from bringup_lint.api import note
from bringup_lint.api import rule

SYMPTOMS = ["tf2.LookupException", "tf2.ExtrapolationException: Lookup would require extrapolation into the future"]


@rule("warning", symptoms=SYMPTOMS)
def transform_unhandled(robot: Robot) -> Iterator[Finding]:
    for file, node in robot.nodes.with_callbacks:
        found = list(nodes.unhandled_transforms(robot.nodes.ending(file), node))
        for first in found[:1]:
            callback = first.callback
            yield finding(
                file.span_of(first.call),
                f"{first.name}() does not handle that the transform is missing or late: the node exits",
                advice="catch tf2_ros.TransformException, and go without this message",
                related=[
                    note(callback.span, f"{callback.name or 'a lambda'} is the callback of {callback.kind}"),
                    *(note(file.span_of(each.call), "the same") for each in found[1:]),
                ],
                severity=nodes.lowered(robot.nodes.purpose(file.source), "warning"),
            )
    for source in robot.nodes.cpp:
        for lookup in source.lookups[:1]:
            callback = lookup.callback
            yield finding(
                lookup.span,
                f"{_name(callback)} does not handle that the transform is missing or late: the process aborts",
                advice="catch tf2::TransformException, and go without this message",
                related=[
                    note(callback.span, f"{callback.name or 'a lambda'} is the callback of {callback.kind}"),
                    *(note(each.span, "the same") for each in source.lookups[1:]),
                ],
                severity=nodes.lowered(robot.nodes.purpose(source.source), "warning"),
            )


def _name(callback: nodes.Callback) -> str:
    return f"{callback.name}()" if callback.name is not None else "The callback"
