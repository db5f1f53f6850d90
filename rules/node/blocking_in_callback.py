"""A callback that blocks stops the whole node.

## What it finds
Calls in a callback, or in the methods that it calls, that keep the executor busy:

- `time.sleep` of 0.1 s or more, `requests.*`, `subprocess.run` and similar functions (not for programs that return
  at once, such as `systemctl poweroff`), `input()`, reads of a serial
  port without a timeout, and `while True`.
- A loop without an end in the constructor: the node never gets to an executor.
- Calls that wait for the executor itself: `client.call()`, `Rate.sleep()`, `rclpy.spin_until_future_complete(self,
  ...)`.

In C++ the same for `sleep_for`, `sleep`, `system`, `wait_for_service()` without a timeout, `while (rclcpp::ok())` and
`rclcpp::spin_until_future_complete`, in files that make no executor with several threads and no callback groups.

## Why it matters on a robot
A single-threaded executor runs one callback after the other. While one blocks, no timer fires and no message is
processed: the watchdog of cmd_vel does not run, and stop commands wait in the queue. A call that waits for an
answer that only the same executor can process waits forever.

## Bad
```python
def on_goal(self, message):
    time.sleep(2.0)
    self.pub.publish(self.stop)
```

## Good
```python
def on_goal(self, message):
    self.later = self.create_timer(2.0, self.halt)
```

## When to ignore it
When the node has nothing urgent to do in the meantime, for example a tool that sets up a device once, or when the
callback runs in a thread that the linter does not see.

## References
- https://docs.ros.org/en/jazzy/How-To-Guides/Sync-Vs-Async.html
- https://docs.ros.org/en/jazzy/Concepts/Intermediate/About-Executors.html
"""

import ast
from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import Source
from bringup_lint.api import finding
from bringup_lint.api import nodes
from bringup_lint.api import note
from bringup_lint.api import rule

WORK = ("subscription", "timer", "service", "action", "client")
URGENT = frozenset({"subscription", "timer", "action"})
"""What must not wait: a service may answer a few seconds later."""

SOON = ("for ", "as long as ")
"""Waits that end by themselves: a subscription that only keeps the newest message may be served after them."""


@rule("warning", tags=["CWE-833"])
def blocking_in_callback(robot: Robot) -> Iterator[Finding]:
    yield from _in_python(robot)
    yield from _in_constructors(robot)
    yield from _in_cpp(robot)


def _in_python(robot: Robot) -> Iterator[Finding]:
    for file, node in robot.nodes.with_callbacks:
        threads = robot.nodes.threads(node)
        for found in nodes.blocking(robot.nodes.ending(file), node):
            callback = found.callback
            shared = [each for each in node.callbacks if each.role in WORK and each.name != callback.name]
            if threads == "several":
                shared = [each for each in shared if each.group == callback.group]
                if found.how_long and callback.group is not None and callback.group.reentrant is not False:
                    continue
            stuck = nodes.deadlocks(found, threads)
            bounded = found.how_long and not found.nested
            ending = robot.nodes.ending(file)
            urgent = [each for each in shared if each.role in URGENT]
            if found.how_long.startswith(SOON):
                urgent = [
                    each for each in urgent if each.role != "subscription" or not nodes.only_stores(ending, node, each)
                ]
            if not urgent if bounded else not stuck:
                continue
            others = f"{len(shared)} other callback{'s' if len(shared) > 1 else ''}"
            where = f"{found.name}()" if callback.function is None else found.name
            message = f"{found.what} in {where} stops the node's {others} {found.how_long}"
            if not found.how_long:
                message = f"{found.what} in {where} waits forever: only the executor that it blocks could end the wait"
            yield finding(
                file.span_of(found.call.test if isinstance(found.call, ast.While) else found.call),
                message,
                advice="use a timer, call_async with add_done_callback, or a separate thread",
                related=[
                    note(callback.span, f"{found.name} is the callback of a {callback.role}"),
                    *(note(each.span, "does not run in the meantime") for each in shared[:3]),
                ],
                severity=grade(robot, file.source, found.how_long),
                confidence="high" if threads == "one" else "medium",
            )


def _in_constructors(robot: Robot) -> Iterator[Finding]:
    for file, node in robot.nodes.with_callbacks:
        callbacks = [each for each in node.callbacks if each.role in WORK]
        loops = list(nodes.endless_constructors(robot.nodes.ending(file), node)) if callbacks else []
        for found in loops[:1]:
            yield finding(
                file.span_of(found.loop.test),
                f"'while {found.test}' in the constructor never ends: none of the node's callbacks ever runs",
                advice="do the work of the loop in the callback of a timer",
                related=[note(each.span, "never runs") for each in callbacks[:3]],
                severity=nodes.lowered(robot.nodes.purpose(file.source), "warning"),
            )


def _in_cpp(robot: Robot) -> Iterator[Finding]:
    for source in robot.nodes.cpp:
        if source.executors:
            continue
        for wait in source.waits:
            callback = wait.callback
            shared = [each for each in source.callbacks if each.span != callback.span and each.role in URGENT]
            if not shared and wait.how_long != nodes.UNTIL_OTHER_NODE:
                continue
            name = f"{callback.name}()" if callback.name is not None else "a lambda"
            lasts = wait.how_long or "forever, because only this executor could end the wait"
            others = f"the node's {len(shared)} other callback{'s' if len(shared) > 1 else ''}"
            yield finding(
                wait.span,
                f"{wait.what} in {name} stops {others if shared else 'the node'} {lasts}",
                advice="use a timer, async_send_request with a callback, or a separate thread",
                related=[
                    note(callback.span, f"{name} is the callback of a {callback.role}"),
                    *(note(each.span, "does not run in the meantime") for each in shared[:3]),
                ],
                severity=grade(robot, source.source),
                confidence="medium",
            )


def grade(robot: Robot, source: Source, how_long: str = "") -> str:
    """Info in examples and in packages of others, and where a timeout of unknown length ends the wait."""
    if robot.launch.workspace.is_vendored(source) or how_long == nodes.UNTIL_TIMEOUT:
        return "info"
    return nodes.lowered(robot.nodes.purpose(source), "warning")
