"""Only Ctrl-C ends the node cleanly, systemd's SIGTERM does not.

## What it finds
`except KeyboardInterrupt` around a spin, where rclpy handles the signals itself and nothing takes
`ExternalShutdownException`.

## Why it matters on a robot
SIGTERM, by which systemd, Docker and the second step of ros2 launch stop a node, makes the spin raise
`rclpy.executors.ExternalShutdownException`. The node ends with a traceback and status 1, the code behind the `try`
does not run, and `Restart=on-failure` takes the stop for a crash.

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
        for caught, spin in nodes.uncaught(robot.nodes.ending(file)):
            place = file.span_of(caught)
            alone = place.source.text[: place.start].rstrip().endswith("except")
            both = f"{place.text}, ExternalShutdownException"
            edit = (place, f"({both})" if alone else both)
            yield finding(
                place,
                "SIGTERM raises ExternalShutdownException: stopped by systemd or Docker, the node ends with a "
                "traceback and status 1",
                advice="catch (KeyboardInterrupt, ExternalShutdownException)",
                related=[
                    note(file.span_of(spin.call), "raised by this spin"),
                    *(note(unit.where, f"{unit.name} stops it") for unit in robot.nodes.units(file)),
                ],
                fix=fix(
                    "catch both",
                    edit,
                    *nodes.import_edits(file, "rclpy.executors", "ExternalShutdownException"),
                ),
                severity="info" if robot.nodes.purpose(file.source) or robot.nodes.by_hand(file.source) else None,
            )
