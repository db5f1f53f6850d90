"""Only Ctrl-C ends the node cleanly; SIGTERM from systemd does not.

## What it finds
`except KeyboardInterrupt` around a spin, when rclpy handles the signals itself and nothing catches
`ExternalShutdownException`. Info in examples and in programs that are started by hand.

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
from bringup_lint.api import finding
from bringup_lint.api import fix
from bringup_lint.api import nodes
from bringup_lint.api import note
from bringup_lint.api import rule


@rule("warning", fix="safe", symptoms=["rclpy.executors.ExternalShutdownException"])
def shutdown_only_keyboardinterrupt(robot: Robot) -> Iterator[Finding]:
    for file in robot.nodes.programs:
        if robot.nodes.stopped_by(file) == {"SIGINT"}:
            continue
        for caught, spin in nodes.unhandled_shutdown(robot.nodes.ending(file)):
            place = file.span_of(caught)
            alone = place.source.text[: place.start].rstrip().endswith("except")
            both = f"{place.text}, ExternalShutdownException"
            edit = (place, f"({both})" if alone else both)
            yield finding(
                place,
                "SIGTERM raises ExternalShutdownException: stopped by systemd or Docker, the node exits with a "
                "traceback and status 1",
                advice="catch (KeyboardInterrupt, ExternalShutdownException)",
                related=[
                    note(file.span_of(spin.call), "raised by this spin"),
                    *(note(runner.where, f"{runner.name} stops it") for runner in robot.nodes.runners(file)),
                ],
                fix=fix(
                    "catch both",
                    edit,
                    *nodes.import_edits(file, "rclpy.executors", "ExternalShutdownException"),
                ),
                severity="info" if robot.nodes.purpose(file.source) or robot.nodes.by_hand(file.source) else None,
            )
