"""Only Ctrl-C ends the node cleanly; SIGTERM from systemd does not.

## What it finds
`except KeyboardInterrupt` around a spin, when rclpy handles the signals itself and nothing catches
`ExternalShutdownException`. An `rclpy.shutdown()` after the spin, which fails on Ctrl-C too, is reported with it.
Info unless a unit, a container or a launch file of the robot starts the program, and in tools that read keys.

## Why it matters on a robot
systemd, Docker and the second step of ros2 launch stop a node with SIGTERM. The spin then raises
`rclpy.executors.ExternalShutdownException`. The node exits with a traceback and status 1, the code after the `try`
does not run, and `Restart=on-failure` treats the stop as a crash.

## Bad
```python
try:
    rclpy.spin(node)
except KeyboardInterrupt:
    pass
```

## Good
```python
try:
    rclpy.spin(node)
except (KeyboardInterrupt, ExternalShutdownException):
    pass
```

## When to ignore it
When the program is only started in a terminal, or when its unit stops it with `KillSignal=SIGINT` in a place
outside this tree.

## References
- tried with rclpy 7.1 (Jazzy)
- https://docs.ros.org/en/jazzy/p/rclpy/, rclpy.executors.ExternalShutdownException
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import Span
from bringup_lint.api import finding
from bringup_lint.api import fix
from bringup_lint.api import nodes
from bringup_lint.api import note
from bringup_lint.api import rule


@rule(
    "warning",
    fix="unsafe",
    symptoms=[
        "rclpy.executors.ExternalShutdownException",
        "failed to shutdown: rcl_shutdown already called on the given context",
    ],
)
def shutdown_only_keyboardinterrupt(robot: Robot) -> Iterator[Finding]:
    for file in robot.nodes.programs:
        if robot.nodes.stopped_by(file) == {"SIGINT"}:
            continue
        ending = robot.nodes.ending(file)
        for caught, spin in nodes.unhandled_shutdown(ending):
            doubles = [call for call, ended in nodes.double_shutdown(ending) if ended == spin]
            ctrl_c = ", and Ctrl-C ends in 'rcl_shutdown already called'" if doubles else ""
            place = file.span_of(caught)
            yield finding(
                place,
                "SIGTERM raises ExternalShutdownException: stopped by systemd or Docker, the node exits with a "
                f"traceback and status 1{ctrl_c}",
                advice="catch (KeyboardInterrupt, ExternalShutdownException)"
                + (" and call rclpy.try_shutdown()" if doubles else ""),
                related=[
                    note(file.span_of(spin.call), "raised by this spin"),
                    *(note(file.span_of(call), "the signal has already shut the context down") for call in doubles),
                    *(note(runner.where, f"{runner.name} stops it") for runner in robot.nodes.runners(file)),
                ],
                fix=fix(
                    "catch both",
                    _both(place),
                    *nodes.import_edits(file, "rclpy.executors", "ExternalShutdownException"),
                    *(edit for call in doubles for edit in nodes.tried_shutdown(ending, call)),
                ),
                severity=None if robot.nodes.is_stopped(file) else "info",
            )


def _both(place: Span) -> tuple[Span, str]:
    """The edit that adds the second exception, in parentheses when the first one has none."""
    alone = place.source.text[: place.start].rstrip().endswith("except")
    both = f"{place.text}, ExternalShutdownException"
    return place, f"({both})" if alone else both
