"""A fixed delay is used to order the start.

## What it finds
A `TimerAction` around nodes that need something which the same start brings up: a comment beside the timer says that
they wait (a warning), or they subscribe to a topic of a node that starts before, or localize, map or navigate on data
of a driver (info: most nodes wait for their topics by themselves, and so do those whose sources wait for a server). One
finding for each file. Also a timer that reports success after checks whose result nothing reads. What waits by itself
(spawners of controllers, components for their container) is left out, and so is what starts only in simulation.

## Why it matters on a robot
On a slow boot, with a full disk or a cold camera, the delay is too short and the consumer starts before the driver.
On a good day the delay wastes time. A check that failed before the timer does not stop it either.

## Bad
```python
Node(package='sllidar_ros2', executable='sllidar_node'),
TimerAction(period=5.0, actions=[Node(package='slam_toolbox', executable='async_slam_toolbox_node')])
```

## Good
```python
RegisterEventHandler(OnStateTransition(target_lifecycle_node=driver, goal_state='active', entities=[slam]))
```

## When to ignore it
When the delay spreads load or inrush current and no start depends on it.

## References
- launch, event handlers; nav2 lifecycle manager
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import NamedTuple
from bringup_lint.api import Robot
from bringup_lint.api import Span
from bringup_lint.api import finding
from bringup_lint.api import launch
from bringup_lint.api import note
from bringup_lint.api import rule

CONSUMERS = ("localization", "mapping", "planning", "control", "costmap")
PROVIDERS = ("driver", "hardware", "localization", "mapping", "map", "perception")


@rule("warning", silent="launch does not know what a delay was for")
def timer_ordering(robot: Robot) -> Iterator[Finding]:
    for file in robot.launch.judged:
        if robot.launch.simulated(file):
            continue
        timers = [action for action, _ in robot.launch.visited(file) if isinstance(action, launch.Timer)]
        found = [(timer, why) for timer in timers if (why := awaited(robot, file, timer)) is not None]
        found.sort(key=lambda pair: not pair[1].said)
        for timer, (node, other, message, said) in found[:1]:
            period = launch.text_of(robot.launch.resolved(timer.period, file))
            what = "This delay" if period is None else f"A delay of {period} s"
            yield finding(
                timer.span,
                f"{what} does not order the start: on a slow boot {node} starts before {message}",
                advice="start it from an event handler, or let a lifecycle manager bring it up",
                related=[note(other, "what it waits for")]
                + [note(each.span, "another delay") for each, _ in found[1:6]],
                severity=None if said else "info",
            )
        if found:
            continue
        for timer in timers:
            yield from announced(robot, file, timer)


class Awaited(NamedTuple):
    node: str
    """What is delayed."""
    place: Span
    """What it waits for."""
    words: str
    said: bool
    """The author says so. Else only the roles of the nodes do, and most nodes wait for their topics by themselves."""


def awaited(robot: Robot, file: launch.LaunchFile, timer: launch.Timer) -> Awaited | None:
    """What a timer delays and for what; None when nothing says that it waits."""
    period = launch.text_of(robot.launch.resolved(timer.period, file))
    if period is not None and period in ("0", "0.0"):
        return None
    expansion = robot.launch.expansion(file)
    nodes = launch.delayed(expansion, timer)
    earlier = launch.undelayed(expansion, nodes)
    starts = nodes or any(timer in each.context and each.target is None for each in expansion.includes)
    comment = launch.waiting_comment(file, timer) if starts else None
    if comment is not None:
        label = nodes[0].label() if len(nodes) == 1 else "the delayed part"
        return Awaited(label, comment, "what it waits for", said=not nodes or not all(map(robot.topics.waits, nodes)))
    for node in nodes:
        other = topic_source(robot, node, timer) or provider(robot, node, earlier)
        if other is not None:
            return Awaited(node.label(), other.span, other.label(), said=False)
    return None


def topic_source(robot: Robot, node: launch.Started, timer: launch.Timer) -> launch.Started | None:
    """The node that publishes what the delayed one subscribes to."""
    for pair in robot.topics.pairs:
        publisher, subscription = pair.publisher.node.started, pair.subscription.node.started
        if subscription.action is node.action and timer in subscription.context and not publisher.context:
            return publisher
    return None


def provider(robot: Robot, node: launch.Started, earlier: list[launch.Started]) -> launch.Started | None:
    role = robot.launch.role(node).role
    if role not in CONSUMERS:
        return None
    return next((each for each in earlier if robot.launch.role(each).role in set(PROVIDERS) - {role}), None)


def announced(robot: Robot, file: launch.LaunchFile, timer: launch.Timer) -> Iterator[Finding]:
    """A timer that says that checks have passed, while nobody looks at their results."""
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
