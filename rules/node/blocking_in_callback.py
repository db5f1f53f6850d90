"""A callback that blocks stops the whole node.

## What it finds
Calls in a callback, or in the methods that it calls, that keep the executor busy:

- `time.sleep` of 0.1 s or more, `requests.*` and the sessions of it, `subprocess.run` and similar functions (not for
  programs that return at once, such as `systemctl poweroff`), `communicate()` and `wait()` of a program, `input()`,
  reads of keys, and of a serial port or a socket without a timeout, and `while True`.
- The first three of these also in the methods of `self.driver`, whose class is in another file of the workspace; once a
  node that waits nowhere else.
- In the callback of a timer, measurements of `psutil` that last longer than its period.
- A loop without an end in the constructor: the node never gets to an executor.
- Calls that wait for the executor itself: `client.call()`, `Rate.sleep()`, `rclpy.spin_until_future_complete(self,
  ...)`.
- Loops that wait for a flag which only another callback sets, for the answer to `call_async()`, or for a message to
  change that is here already.

Several threads (`MultiThreadedExecutor`) run the callbacks of other groups in the meantime, and all others while an
action server executes a goal: rclpy does that outside all callback groups.

In C++ the same for `sleep_for`, `sleep`, `system`, `wait_for_service()` without a timeout, `wait` of a condition
variable, reads of a socket without a timeout, `while (rclcpp::ok())`, loops that wait for a flag, `rclcpp::spin` and
`rclcpp::spin_until_future_complete`, in files that make no executor with several threads and no callback groups; and
for `get()` and `wait()` of the answer to a client in the callback group that the callback blocks, however many threads
there are.

It is an info where the node reads keys and has nothing else to do.

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
from collections.abc import Sequence

from bringup_lint.api import Finding
from bringup_lint.api import Related
from bringup_lint.api import Robot
from bringup_lint.api import Source
from bringup_lint.api import Span
from bringup_lint.api import finding
from bringup_lint.api import nodes
from bringup_lint.api import note
from bringup_lint.api import rule

UNTIL_KEY = "until a key is pressed"


@rule("warning", silent="other callbacks of the node are late, and rclpy does not report it", tags=["CWE-833"])
def blocking_in_callback(robot: Robot) -> Iterator[Finding]:
    yield from _in_python(robot)
    yield from _in_constructors(robot)
    yield from _in_cpp(robot)


def _in_python(robot: Robot) -> Iterator[Finding]:
    for file, wait, stopped, certain, period in nodes.stopped_callbacks(robot.nodes):
        where = f"{wait.name}()" if wait.callback.function is None else wait.name
        whom = f"the node's {_others(len(stopped))}" if stopped else "the node"
        what = f"{wait.what} in {where}" if not wait.inner else f"{wait.inner} by {wait.what} in {where}"
        message = f"{what} stops {whom} {wait.how_long}"
        if period is not None:
            message += f": the timer is due every {period:.2g} s"
        if not wait.how_long:
            message = f"{wait.what} in {where} waits forever: only the executor that it blocks could end the wait"
        yield finding(
            file.span_of(wait.call.test if isinstance(wait.call, ast.While) else wait.call),
            message,
            advice="use a timer, call_async with add_done_callback, or a separate thread",
            related=[
                *([note(wait.where, "waits here")] if wait.where is not None else []),
                *([note(file.span_of(wait.made), "made here, without a timeout")] if wait.made is not None else []),
                *_related(wait.callback.span, f"{wait.name} is the callback of {wait.callback.kind}", stopped),
            ],
            severity="info" if is_for_keys(wait.how_long, stopped) else _severity(robot, file.source, wait.how_long),
            confidence="high" if certain else "medium",
        )


def _in_constructors(robot: Robot) -> Iterator[Finding]:
    for file, found, callbacks in nodes.never_run(robot.nodes):
        yield finding(
            file.span_of(found.loop.test),
            f"'while {found.test}' in the constructor never ends: none of the node's callbacks ever runs",
            advice="do the work of the loop in the callback of a timer",
            related=[note(each.span, "never runs") for each in callbacks[:3]],
            severity=robot.nodes.lowered(file.source, "warning"),
        )


def _in_cpp(robot: Robot) -> Iterator[Finding]:
    for source, wait, stopped in nodes.stopped_in_cpp(robot.nodes):
        callback = wait.callback
        name = f"{callback.name}()" if callback.name is not None else "a lambda"
        lasts = wait.how_long or "forever, because only this executor could end the wait"
        whom = f"the node's {_others(len(stopped))}" if stopped else "the node"
        yield finding(
            wait.span,
            f"{wait.what} in {name} stops {whom} {lasts}",
            advice="use a timer, async_send_request with a callback, or a separate thread",
            related=_related(callback.span, f"{name} is the callback of a {callback.role}", stopped),
            severity=_severity(robot, source),
            confidence="medium",
        )


def _others(count: int) -> str:
    return f"{count} other callback{'s' if count > 1 else ''}"


def _related(waiting: Span, role: str, stopped: Sequence[nodes.Callback]) -> list[Related]:
    return [note(waiting, role), *(note(each.span, "does not run in the meantime") for each in stopped[:3])]


def is_for_keys(how_long: str, stopped: Sequence[nodes.Callback]) -> bool:
    """Whether the node waits for keys and has nothing else to do."""
    return how_long == UNTIL_KEY and not stopped


def _severity(robot: Robot, source: Source, how_long: str = "") -> str:
    """Info in examples and in packages of others, and where a timeout of unknown length ends the wait."""
    if robot.launch.workspace.is_vendored(source) or how_long == nodes.UNTIL_TIMEOUT:
        return "info"
    return robot.nodes.lowered(source, "warning")
