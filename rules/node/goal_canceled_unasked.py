"""An action server ends a goal as canceled that nobody asked it to cancel.

## What it finds
`goal_handle.canceled()` in a function that has another branch for goals that are to be canceled
(`is_cancel_requested`, `is_canceling()`), under conditions that have nothing to do with that: a goal of an unknown
kind, one that a newer goal replaces. In C++ also in the callback of a subscription or service, and in the function that
answers whether a goal may be canceled, which is called before it is.

## Why it matters on a robot
A goal can only be canceled after the server accepted a request to cancel it. In all other cases the call throws: in
Python the exception ends the callback, and the goal is aborted with no result; in C++ nothing catches it in a thread
of its own, and the whole node ends.

## Bad
```python
if self.newest is not goal_handle:
    goal_handle.canceled()
    return result
```

## Good
```python
if self.newest is not goal_handle:
    goal_handle.abort()
    return result
```

## When to ignore it
When the condition can only be true after a request to cancel the goal.

## References
- https://design.ros2.org/articles/actions.html, "Goal States"
- rcl_action, goal_state_machine.c
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Related
from bringup_lint.api import Robot
from bringup_lint.api import Source
from bringup_lint.api import Span
from bringup_lint.api import finding
from bringup_lint.api import nodes
from bringup_lint.api import note
from bringup_lint.api import rule


@rule(
    "warning",
    confidence="medium",
    symptoms=["goal_handle attempted invalid transition from state EXECUTING with event CANCELED"],
)
def goal_canceled_unasked(robot: Robot) -> Iterator[Finding]:
    asked = "goals that are to be canceled end here"
    for found in nodes.canceled_goals(robot.nodes):
        place, end = found.file.span_of(found.call), found.file.span_of(found.asked)
        yield _finding(robot, found.file.source, place, note(end, asked))
    for node in robot.nodes.cpp:
        for each in node.canceled:
            what = f"{each.runs} calls this while the goal is executed" if each.runs else asked
            yield _finding(robot, node.source, each.span, note(each.asked, what), decides=each.decides)


def _finding(robot: Robot, source: Source, place: Span, where: Related, *, decides: bool = False) -> Finding:
    if decides:
        message = "The goal becomes one that is to be canceled only after this function has returned: the call throws"
        advice = "end it where it is executed, when is_canceling() says so"
    else:
        message = (
            "Nobody asked to cancel the goal here: the call throws, because a goal that is executed can't become "
            "canceled"
        )
        advice = "end it with abort()"
    return finding(place, message, advice=advice, related=[where], severity=robot.nodes.lowered(source, "warning"))
