"""A fixed delay is used to order the start.

## What it finds
`TimerAction` around nodes or includes. Also a timer that reports success after checks whose result nothing reads.

## Why it matters on a robot
On a slow boot, with a full disk or a cold camera, the delay is too short and the consumer starts before the driver.
On a good day the delay wastes time. A check that failed before the timer does not stop it either.

## Bad
```python
TimerAction(period=5.0, actions=[Node(package='nav2_planner', executable='planner_server')])
```

## Good
```python
RegisterEventHandler(OnStateTransition(target_lifecycle_node=driver, goal_state='active', entities=[planner]))
```

## When to ignore it
When the delay spreads load or inrush current and no start depends on it.

## References
- launch, event handlers; nav2 lifecycle manager
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import launch
from bringup_lint.api import note
from bringup_lint.api import rule


@rule("warning")
def timer_ordering(robot: Robot) -> Iterator[Finding]:
    for file in robot.launch.judged:
        if robot.launch.simulated(file):
            continue
        for action, _ in robot.launch.visited(file):
            if not isinstance(action, launch.Timer):
                continue
            started = [
                inner
                for inner in launch.walk_actions(action.actions)
                if isinstance(inner, (launch.Node, launch.Include, launch.LoadComponents))
            ]
            if not started:
                yield from announced(robot, file, action)
                continue
            period = launch.text_of(robot.launch.resolved(action.period, file))
            if period in ("0", "0.0"):
                continue
            what = "This" if period is None else f"A delay of {period} s"
            yield finding(
                action.span,
                f"{what} does not order the start: on a slow boot these {len(started)} start before what they wait for"
                if len(started) > 1
                else f"{what} does not order the start: on a slow boot it starts before what it waits for",
                advice="start it from an event handler, or let a lifecycle manager bring it up",
            )


def announced(robot: Robot, file: launch.LaunchFile, timer: launch.Timer) -> Iterator[Finding]:
    """A timer that only says that checks have passed, while nobody looks at their results."""
    expansion = robot.launch.expansion(file)
    checks = [node for node in expansion.nodes if node.file is file and launch.check_of(node)]
    ignored = [node for node in checks if not launch.watched(node, expansion)]
    if ignored and any(isinstance(inner, launch.Log) for inner in timer.actions):
        yield finding(
            timer.span,
            "This message appears after a fixed delay, whatever the checks before it found",
            advice="log it in an OnProcessExit handler of the checks",
            related=[note(node.span, "nothing waits for this check") for node in ignored[:5]],
        )
