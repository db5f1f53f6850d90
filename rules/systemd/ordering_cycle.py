"""Units whose start order forms a cycle.

## What it finds
A cycle in the start order. Its edges come from these sources:

- `After=` and `Before=` lines, drop-ins and `.wants` links;
- orders that systemd adds: a target after the units that it wants, a mount before the units that need its
  path, a timer before its service;
- orders of the distribution's units.

It is an info when no common unit starts all members of the cycle, because the cycle has no effect until one
does. `systemd/wantedby-and-after-later-target` reports a single unit that conflicts with targets alone.

## Why it matters on a robot
systemd breaks the cycle: it drops a job that nothing requires. Which one it drops depends on the order of a
hash table. On one boot the lidar is missing, on the next one the planner. There is one line in the journal
and no failed unit. If all members are required, the whole start fails.

## Bad
```ini
# drivers.service
[Unit]
After=planner.service

# planner.service
[Unit]
After=drivers.service
```

## Good
```ini
# planner.service
[Unit]
After=drivers.service
```

## When to ignore it
The info, when conditions of a template exclude each other, and when the units are alternatives that are never
enabled together.

## References
- systemd.unit(5), "Before=, After="
- systemd.target(5), "Default Dependencies"
- bootup(7)
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import note
from bringup_lint.api import rule
from bringup_lint.api.systemd import Cycle


@rule(
    "error",
    symptoms=[
        "Found ordering cycle on",
        "deleted to break ordering cycle starting with",
        "Transaction order is cyclic. See system logs for details.",
        "Found dependency on",
        "Unable to break cycle starting with",
    ],
)
def ordering_cycle(robot: Robot) -> Iterator[Finding]:
    for cycle in robot.units.cycles:
        lines = [edge.where for edge in cycle.waits if edge.where and edge.where.source.judged]
        if not lines or cycle.against_targets:
            continue
        steps = [
            note(edge.where, f"{edge.target.name} waits for {edge.source.name}") for edge in cycle.waits if edge.where
        ]
        yield finding(
            lines[0],
            f"Ordering cycle {cycle}: {_effect(cycle)}",
            advice="remove the order that contradicts the layers: drivers first, then the units that use them",
            related=steps[1:],
            chain=steps,
            severity=None if cycle.root and not cycle.uncertain else "info",
        )


def _effect(cycle: Cycle) -> str:
    if cycle.fatal:
        return "each of them is required, so the start fails"
    if cycle.root is None:
        return "nothing starts all of them together yet; when something does, systemd drops one"
    names = sorted(node.name for node in cycle.droppable)
    dropped = f"drops {names[0]}" if len(names) == 1 else f"drops one of {', '.join(names)}"
    return (f"systemd {dropped} when {cycle.root.name} starts") + (
        ", not always the same one" if len(names) > 1 else ""
    )
