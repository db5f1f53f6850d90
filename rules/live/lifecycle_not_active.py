"""A running lifecycle node is not active.

## What it finds
Lifecycle nodes of the running graph in another state than `active`, and those that do not tell their state within
2 s. Nodes whose lifecycle manager is told not to start them (`autostart` false) are left out. For nodes that the
files do not name, and while a transition is going on, it is a warning; for inactive nodes that the files do not
name, such as controllers in reserve, an information.

## Why it matters on a robot
The process runs and the node is listed; it publishes nothing and refuses every goal. A manager that gave up at
the first failing node leaves all nodes behind it unconfigured.

## Bad
```yaml
nodes:
- {name: /map_server, enclave: /, state: inactive}
```

## Good
```yaml
nodes:
- {name: /map_server, enclave: /, state: active}
```

## References
- ROS 2 design, "Managed nodes"
- nav2, lifecycle manager
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import note
from bringup_lint.api import rule

PASSING = ("configuring", "activating", "deactivating", "cleaningup", "shuttingdown", "errorprocessing")


@rule("error", symptoms=["Failed to bring up all requested nodes. Aborting bringup", "Failed to change state for node"])
def lifecycle_not_active(robot: Robot) -> Iterator[Finding]:
    observed = robot.observed
    for node in observed.nodes:
        if node.state in (None, "active") or observed.stays_inactive(node.name):
            continue
        known = observed.expected.named(node.name)
        entry, manager = observed.managed.get(node.name, (None, None))
        silent = node.state == "no answer"
        ours = known or entry
        settled = not silent and node.state not in PASSING
        where = observed.place(node.name)
        related = [note(node.state, "its state")] if where.source is not node.name.span.source else []
        yield finding(
            where,
            f"{node.name} does not tell its lifecycle state within 2 s"
            if silent
            else f"{node.name} is {node.state}, not active: it runs and does nothing",
            advice="look at its log for the transition that failed"
            + (f", and at that of {manager.node.label()}" if manager else ""),
            related=[*([note(entry.name, "a lifecycle manager is to activate it")] if entry else []), *related],
            severity="info" if not ours and node.state == "inactive" else "error" if ours and settled else "warning",
        )
