"""launch restarts a process without a delay.

## What it finds
`respawn=True` without `respawn_delay`, or with a delay of 0. Tools such as rviz, and launch files for simulation,
are not reported, nor commands that run a container, whose start limits the rate. For a program whose sources are in the
tree and drive no hardware, half a second is advised, else two.

## Why it matters on a robot
A driver whose device is unplugged crashes and restarts hundreds of times a minute. It uses up a core, floods the
disk with logs, and gives the device no time to come back.

## Bad
```python
Node(package='lidar', executable='lidar_node', respawn=True)
```

## Good
```python
Node(package='lidar', executable='lidar_node', respawn=True, respawn_delay=2.0)
```

## When to ignore it
When the process needs seconds before it can fail, so that its own start-up limits the rate, and every lost second
matters.

## References
- launch, `ExecuteLocal`: `respawn_delay` is 0.0 by default
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import NamedTuple
from bringup_lint.api import Robot
from bringup_lint.api import Source
from bringup_lint.api import Span
from bringup_lint.api import finding
from bringup_lint.api import fix
from bringup_lint.api import launch
from bringup_lint.api import note
from bringup_lint.api import rule
from bringup_lint.api.topics import device_role

AFTER = {"python": (0, ", respawn_delay={}"), "xml": (1, ' respawn_delay="{}"')}
"""Characters after the value of respawn, and the delay that is written there. In YAML it is a line of its own."""
OF_DEVICE, OF_PROGRAM = "2.0", "0.5"
"""Seconds in which a device comes back, and those that spare the core where the program has none to wait for."""


@rule("warning", fix="unsafe", silent="launch reports only that a process has died and that one has started")
def respawn_no_delay(robot: Robot) -> Iterator[Finding]:
    found: dict[Source, dict[Span, Hasty]] = {}
    for hasty in restarted_at_once(robot):
        found.setdefault(hasty.value.source, {}).setdefault(hasty.value, hasty)
    for alike in found.values():
        first, *others = alike.values()
        edits = [each.edit for each in alike.values() if each.edit is not None]
        delays = sorted({each.delay for each in alike.values()})
        yield finding(
            first.value,
            f"{first.label} is restarted without a delay: a crash at start uses up a core and floods the log",
            advice=f"set respawn_delay to {delays[-1]}"
            + (f" for what waits for a device, and to {delays[0]} for the others" if len(delays) > 1 else ""),
            related=[note(other.value, f"so is {other.label}") for other in others],
            fix=fix(f"wait {' or '.join(f'{float(each):g} s' for each in delays)}", *edits) if edits else None,
        )


class Hasty(NamedTuple):
    """A process that launch restarts at once."""

    label: str
    value: Span
    delay: str
    """Seconds that launch is to wait."""
    edit: tuple[Span, str] | None
    """What makes launch wait; None where the delay is not written with the node."""


def restarted_at_once(robot: Robot) -> Iterator[Hasty]:
    for node in robot.launch.nodes:
        if not isinstance(node.action, launch.Process) or node.action.open or robot.launch.simulated(node.file):
            continue
        if robot.launch.role(node).role == "tool" or is_container(node.action):
            continue
        value = node.action.options.get("respawn")
        delay = node.options.get("respawn_delay")
        if value is None or launch.respawns(node) is not True:
            continue
        if delay is not None and launch.text_of(delay) not in ("0", "0.0"):
            continue
        span = (node.action.options["respawn_delay"] if delay is not None else value).span
        own = span.source is node.file.source and span.start >= node.span.start and span.end <= node.span.end
        form = node.file.format if own and delay is None else ""
        seconds = OF_PROGRAM if has_no_device(robot, node) else OF_DEVICE
        yield Hasty(node.label(), value.span, seconds, _edit(span, form, seconds) if form in AFTER else None)


def _edit(span: Span, form: str, seconds: str) -> tuple[Span, str]:
    skipped, text = AFTER[form]
    return span.source.span(span.end + skipped, span.end + skipped), text.format(seconds)


def has_no_device(robot: Robot, node: launch.Started) -> bool:
    """Whether the sources of a program are in the tree, and drive no hardware."""
    package = launch.literal_text(node.package)
    is_own = package in robot.launch.workspace.packages and robot.topics.code(node) is not None
    return is_own and device_role(robot.topics, node) is None


def is_container(action: launch.Process) -> bool:
    """Whether the command runs a container, whose start takes seconds by itself."""
    first = launch.text_of(action.cmd[0]) if action.cmd else None
    return first is not None and first.split(maxsplit=1)[:1] in ([each] for each in ("docker", "podman"))
