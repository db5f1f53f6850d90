"""A transform is looked up without handling that there is none.

## What it finds
`lookup_transform()` and `transform()` of a tf2 buffer in Python, and `lookupTransform()` in C++, in a callback of a
subscription, timer, service or client, when no `try` surrounds the call and `can_transform()` is not asked before. In
C++ only where the callback itself makes the call. Action servers of Python are left out: rclpy catches what their
callbacks raise. Also lookups in the constructor of a Python node whose `TransformListener` has no thread of its own.
In C++ also a handler that only logs, when the function then uses the message that has not been filled.

## Why it matters on a robot
Each start begins without transforms, and each transform arrives after the sensor data that it belongs to. tf2 raises
LookupException, ConnectivityException or ExtrapolationException then. The exception leaves `spin()`, and the node
ends: usually with the first message, later whenever localization is late once. While the constructor runs, nothing
spins the node yet. The listener gets no transform, and the lookup fails at every start, whatever its timeout is. A
message that was not filled is a goal at the origin of the frame, which may be on the other side of a wall.

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
from bringup_lint.api import NamedTuple
from bringup_lint.api import Robot
from bringup_lint.api import Span
from bringup_lint.api import finding
from bringup_lint.api import nodes
from bringup_lint.api import note
from bringup_lint.api import rule


class Language(NamedTuple):
    exception: str
    end: str


PYTHON = Language("tf2_ros.TransformException", "the node exits")
CPP = Language("tf2::TransformException", "the process aborts")


@rule(
    "warning",
    symptoms=["tf2.LookupException", "tf2.ExtrapolationException: Lookup would require extrapolation into the future"],
)
def transform_unhandled(robot: Robot) -> Iterator[Finding]:
    for file, node in robot.nodes.node_classes:
        found = list(nodes.unhandled_transforms(robot.nodes.ending(file), node))
        if found:
            spans = [file.span_of(each.call) for each in found]
            python = PYTHON._replace(end=nodes.end_of(robot.nodes.syntax(file), found[0].call))
            yield _finding(robot, python, spans, found[0].callback, f"{found[0].name}()")
        for call in nodes.early_lookups(robot.nodes.ending(file), node)[:1]:
            yield finding(
                file.span_of(call),
                "The constructor looks up a transform before anything spins the node: none has arrived, at any start",
                advice="look it up in the callback of a timer, and try again until it is there",
                severity=robot.nodes.lowered(file.source, "error"),
            )
    for source in robot.nodes.cpp:
        if source.lookups:
            callback = source.lookups[0].callback
            name = f"{callback.name}()" if callback.name is not None else "The callback"
            yield _finding(robot, CPP, [each.span for each in source.lookups], callback, name)
    for driver in robot.nodes.drivers:
        for lost in driver.lost_transforms:
            yield finding(
                lost.handled,
                f"When there is no transform, this only logs: what follows uses '{lost.name}' as it was made, at the "
                "origin of its frame",
                advice="return here, and go without this message",
                related=[note(lost.looked_up, "fills it"), note(lost.used, "used whether it was filled or not")],
                severity=robot.nodes.lowered_if_vendored(driver.source, "warning"),
            )


def _finding(robot: Robot, language: Language, spans: list[Span], callback: nodes.Callback, function: str) -> Finding:
    first, *others = spans
    return finding(
        first,
        f"{function} does not handle that the transform is missing or late: {language.end}",
        advice=f"catch {language.exception}, and go without this message",
        related=[
            note(callback.span, f"{callback.name or 'a lambda'} is the callback of {callback.kind}"),
            *(note(each, "the same") for each in others),
        ],
        severity=robot.nodes.lowered(first.source, "warning"),
    )
