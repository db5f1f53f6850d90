"""Units that wait for each other in a circle.

## What it finds
Cycles in the start order: `After=` and `Before=` lines, drop-ins and `.wants` links, together with the
order that systemd adds on its own (a target comes after what it wants, a mount before what lies on it, a
timer before its service) and the order of the distribution's units. A cycle whose members no common unit
brings in is reported as info: it waits for the day when they meet. A single unit that is in conflict with
targets alone is a matter for `systemd/wantedby-and-after-later-target`.

## Why it matters on a robot
systemd breaks the cycle by leaving out a job that nothing requires, and which one that is depends on the
order of a hash table: on one boot the lidar is missing, on the next one the planner. There is one line in
the journal and no failed unit. If all members are required, the whole start fails.

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


@rule(
    "error",
    symptoms=[
        "Found ordering cycle on",
        "deleted to break ordering cycle starting with",
        "Transaction order is cyclic",
    ],
)
def ordering_cycle(robot: Robot) -> Iterator[Finding]:
    for cycle in robot.units.cycles:
        lines = [edge for edge in cycle.waits if edge.where and edge.where.source.judged]
        if not lines or cycle.against_targets:
            continue
        steps = [
            note(edge.where, f"{edge.target.name} waits for {edge.source.name}") for edge in cycle.waits if edge.where
        ]
        yield finding(
            lines[0].where,
            f"Ordering cycle {cycle}: {_effect(cycle)}",
            advice="take out the edge that contradicts the layers: drivers first, what uses them later",
            related=steps[1:],
            chain=steps,
            severity=None if cycle.root else "info",
        )


def _effect(cycle):
    if cycle.fatal:
        return "each of them is required, so the start fails"
    if cycle.root is None:
        return "nothing starts all of them together yet; once something does, one is left out"
    names = sorted(node.name for node in cycle.droppable)
    dropped = f"leaves out {names[0]}" if len(names) == 1 else f"leaves out one of {', '.join(names)}"
    return (f"systemd {dropped} when {cycle.root.name} starts") + (", not always the same" if len(names) > 1 else "")
