"""The loop of a lifecycle node does not run again after the node was deactivated.

## What it finds
A `threading.Event` or a flag of a Python lifecycle node that `on_deactivate()` sets, that ends a loop, and that at most
`on_configure()` or the constructor takes back.

## Why it matters on a robot
A lifecycle manager deactivates and activates nodes without configuring them anew, for example when a map is loaded or
the emergency stop is released. The transition succeeds, the node is in the state active, and its loop ends at its first
turn: nothing is sent or connected any more, and nothing says so.

## Bad
```python
def on_configure(self, state):
    self.stop.clear()

def on_activate(self, state):
    threading.Thread(target=self.work).start()  # while not self.stop.is_set()

def on_deactivate(self, state):
    self.stop.set()
```

## Good
```python
def on_activate(self, state):
    self.stop.clear()
    threading.Thread(target=self.work).start()
```

## When to ignore it
When the node is always cleaned up and configured between two activations.

## References
- https://design.ros2.org/articles/node_lifecycle.html, "Deactivating": from active to inactive, without `onCleanup`
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import nodes
from bringup_lint.api import note
from bringup_lint.api import rule


@rule("warning", silent="the node is active, and its loop has ended")
def lifecycle_activate_once(robot: Robot) -> Iterator[Finding]:
    for file, node in robot.nodes.node_classes:
        for found in nodes.stuck_switches(robot.nodes.syntax(file), node):
            yield finding(
                file.span_of(found.switched),
                f"After deactivate and activate, {found.name} still has this value: the loop ends at once",
                advice=f"take {found.name} back in on_activate()",
                related=[
                    note(file.span_of(found.loop.test), "does not run any more"),
                    *([note(file.span_of(found.back), "does not run in between")] if found.back is not None else []),
                ],
                severity=robot.nodes.lowered_if_vendored(file.source, "warning"),
            )
