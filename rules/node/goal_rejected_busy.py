"""A flag that stays set when the action server rejects a goal.

## What it finds
A node that sets a flag when it sends a goal, resets it only in what runs after the goal was accepted, and returns from
the callback of a rejected goal without resetting it. A condition of the node asks for the flag.

## Why it matters on a robot
Nav2 rejects goals while it is not active, and MoveIt while it executes another one. After one rejection the flag says
forever that a goal is on its way: the node sends no other, and nothing in the log says why the robot waits.

## Bad
```python
def on_answer(self, future):
    handle = future.result()
    if not handle.accepted:
        return
    handle.get_result_async().add_done_callback(self.on_result)   # resets self.busy
```

## Good
```python
def on_answer(self, future):
    handle = future.result()
    if not handle.accepted:
        self.busy = False
        return
    handle.get_result_async().add_done_callback(self.on_result)
```

## When to ignore it
When a person restarts the node after a rejected goal.

## References
- https://docs.ros.org/en/jazzy/Tutorials/Intermediate/Writing-an-Action-Server-Client/Py.html
- Nav2, bt_navigator: goals are rejected while the navigator is inactive
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import nodes
from bringup_lint.api import note
from bringup_lint.api import rule


@rule("warning", silent="the node waits, as it does while a goal is executed")
def goal_rejected_busy(robot: Robot) -> Iterator[Finding]:
    for found in nodes.stuck_flags(robot.nodes):
        yield finding(
            found.file.span_of(found.branch.test),
            f"self.{found.name} stays True after a rejected goal: only the result of an accepted one resets it",
            advice=f"set self.{found.name} to False in this branch",
            related=[
                note(found.file.span_of(found.set_at), "set here"),
                note(found.file.span_of(found.asked), "asked here"),
            ],
            severity=robot.nodes.lowered(found.file.source, "warning"),
        )
