"""Only Ctrl-C ends the node cleanly; SIGTERM from systemd does not.

## What it finds
`except KeyboardInterrupt` around a spin, when rclpy handles the signals itself and nothing catches
`ExternalShutdownException`. An `rclpy.shutdown()` after the spin, which fails on Ctrl-C too, is reported with it.
The programs of a package make one finding. Info unless a unit, a container or another runner starts the program or a
launch file with it, and in tools that read keys: nothing of the tree sends the signal there.

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
from bringup_lint.api import regex
from bringup_lint.api import rule

WORKS = regex(
    r"\b(?:create_(?:timer|subscription|service|client|rate)|Action(?:Server|Client)|Subscriber|Thread|serial|GPIO)\b"
)
"""What keeps a node at work."""


@rule(
    "warning",
    fix="unsafe",
    symptoms=[
        "rclpy.executors.ExternalShutdownException",
        "failed to shutdown: rcl_shutdown already called on the given context",
    ],
)
def shutdown_only_keyboardinterrupt(robot: Robot) -> Iterator[Finding]:
    found: dict[tuple[object, ...], list[Unhandled]] = {}
    for each in unhandled(robot):
        package = robot.launch.workspace.owner(each.file.source) or each.file
        found.setdefault((package, each.stopped, bool(each.doubles)), []).append(each)
    for alike in found.values():
        yield _finding(robot, alike)


class Unhandled(NamedTuple):
    """A handler of KeyboardInterrupt alone, the spin in its ``try``, and the shutdowns that come too late."""

    file: nodes.NodeSource
    caught: Span
    spin: Span
    doubles: list[ast.Call]
    stopped: bool


def unhandled(robot: Robot) -> Iterator[Unhandled]:
    for file in robot.nodes.robot_sources:
        if nodes.stopped_by(robot.nodes, file) == {"SIGINT"}:
            continue
        ending = robot.nodes.ending(file)
        for caught, spin in nodes.unhandled_shutdown(ending):
            doubles = [call for call, ended in nodes.double_shutdown(ending) if ended == spin]
            stopped = nodes.is_stopped(robot.nodes, file)
            yield Unhandled(file, file.span_of(caught), file.span_of(spin.call), doubles, stopped)


def _finding(robot: Robot, alike: list[Unhandled]) -> Finding:
    """One finding for the programs of a package, which people write after the same pattern."""
    first, *others = alike
    doubles = [first.file.span_of(call) for call in first.doubles]
    ctrl_c = ", and Ctrl-C ends in 'rcl_shutdown already called'" if doubles else ""
    return finding(
        first.caught,
        "SIGTERM raises ExternalShutdownException: stopped by systemd or Docker, the node exits with a "
        f"traceback and status 1{ctrl_c}",
        advice="catch (KeyboardInterrupt, ExternalShutdownException)"
        + (" and call rclpy.try_shutdown()" if doubles else ""),
        related=[
            note(first.spin, "raised by this spin"),
            *(note(place, "the signal has already shut the context down") for place in doubles),
            *(note(runner.where, f"{runner.name} stops it") for runner in nodes.runners_of(robot.nodes, first.file)),
            *(note(other.caught, "the same in this program of the package") for other in others),
        ],
        fix=fix("catch both", *(edit for each in alike for edit in _edits(robot, each))),
        severity=None if first.stopped and not all(_is_done(each.file) for each in alike) else "info",
    )


def _is_done(file: nodes.NodeSource) -> bool:
    """Whether a node does nothing any more after its start: it has nothing to stop or to save."""
    return WORKS.search(file.source.text) is None


def _edits(robot: Robot, each: Unhandled) -> Iterator[tuple[Span, str]]:
    yield _both(each.caught)
    yield from nodes.import_edits(each.file, "rclpy.executors", "ExternalShutdownException")
    for call in each.doubles:
        yield from nodes.tried_shutdown(robot.nodes.ending(each.file), call)


def _both(place: Span) -> tuple[Span, str]:
    """The edit that adds the second exception, in parentheses when the first one has none."""
    alone = place.source.line_before(place.start).rstrip().endswith("except")
    both = f"{place.text}, ExternalShutdownException"
    return place, f"({both})" if alone else both
