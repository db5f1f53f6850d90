"""rclpy.shutdown() is called after a signal has shut the context down.

## What it finds
`rclpy.shutdown()` in a `finally`, in an `except KeyboardInterrupt`, or after such a `try`, when rclpy handles the
signals itself and neither `rclpy.ok()` nor another `try` guards the call. Where the same `try` does not catch
`ExternalShutdownException` either, `node/shutdown-only-keyboardinterrupt` reports both. Info unless a unit, a
container or a launch file of the robot starts the program.

## Why it matters on a robot
On SIGINT and SIGTERM rclpy shuts the context down before the `finally` runs. The second shutdown raises an
exception, so every Ctrl-C and every stop by systemd ends with a traceback and status 1. The unit is "failed", and
real crashes are lost in the noise. The fix is unsafe: with status 0, `Restart=on-failure` and `OnFailure=` of its unit
no longer take a stop for a crash.

## Bad
```python
try:
    rclpy.spin(node)
except (KeyboardInterrupt, ExternalShutdownException):
    pass
finally:
    rclpy.shutdown()
```

## Good
```python
try:
    rclpy.spin(node)
except (KeyboardInterrupt, ExternalShutdownException):
    pass
finally:
    rclpy.try_shutdown()
```

## When to ignore it
When the program is only ever started by hand and a traceback at its end does not matter.

## References
- tried with rclpy 7.1 (Jazzy)
- https://docs.ros.org/en/jazzy/p/rclpy/, rclpy.try_shutdown
"""

import ast
from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import NamedTuple
from bringup_lint.api import Robot
from bringup_lint.api import Span
from bringup_lint.api import finding
from bringup_lint.api import fix
from bringup_lint.api import nodes
from bringup_lint.api import note
from bringup_lint.api import rule


@rule("warning", fix="unsafe", symptoms=["failed to shutdown: rcl_shutdown already called on the given context"])
def shutdown_double(robot: Robot) -> Iterator[Finding]:
    found: dict[tuple[object, bool], list[Late]] = {}
    for file in robot.nodes.robot_sources:
        package = robot.launch.workspace.owner(file.source) or file
        found.setdefault((package, nodes.is_stopped(robot.nodes, file)), []).extend(late(robot, file))
    for (_, stopped), alike in found.items():
        if alike:
            yield _finding(robot, alike, stopped)


class Late(NamedTuple):
    """A shutdown after the spin that a signal has ended together with the context."""

    file: nodes.NodeSource
    call: ast.Call
    spin: Span


def late(robot: Robot, file: nodes.NodeSource) -> Iterator[Late]:
    ending = robot.nodes.ending(file)
    uncaught = () if nodes.stopped_by(robot.nodes, file) == {"SIGINT"} else nodes.unhandled_shutdown(ending)
    told = {each.spin for each in uncaught}
    for call, spin in nodes.double_shutdown(ending):
        if spin not in told:
            yield Late(file, call, file.span_of(spin.call))


def _finding(robot: Robot, alike: list[Late], stopped: bool) -> Finding:
    """One finding for the programs of a package, which people write after the same pattern."""
    first, *others = alike
    edits = (nodes.tried_shutdown(robot.nodes.ending(each.file), each.call) for each in alike)
    return finding(
        first.file.span_of(first.call),
        "'rcl_shutdown already called': Ctrl-C and a stop by systemd end in this exception and status 1, "
        "because the signal has already shut the context down",
        advice="call rclpy.try_shutdown()",
        related=[
            note(first.spin, "the signal ends this spin"),
            *(note(each.file.span_of(each.call), "the same in this program of the package") for each in others),
        ],
        fix=fix("call rclpy.try_shutdown()", *(edit for each in edits for edit in each)),
        severity=None if stopped else "info",
    )
