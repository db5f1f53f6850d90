"""A running lifecycle node is not active.

## What it finds
Lifecycle nodes of the running graph that are in another state than `active`, or that do not report their state
within 2 s. Nodes whose lifecycle manager does not start them (`autostart` false) are not reported. The severity
depends on the case:

- Error: the files name the node, and its state is final.
- Warning: the node is in a transition or does not answer, or the files do not name it.
- Info: the files do not name the node and it is inactive, such as a controller in reserve.

## Why it matters on a robot
The process runs and the node is listed, but it publishes nothing and rejects every goal. A manager that gave up at
the first failing node leaves all later nodes unconfigured.

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

## When to ignore it
When the node is meant to be inactive at the moment, for example a docking server that is activated only near the
dock.

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
            f"{node.name} does not report its lifecycle state within 2 s"
            if silent
            else f"{node.name} is {node.state}, not active: it runs but does nothing",
            advice="look in its log for the transition that failed"
            + (f", and in the log of {manager.node.label()}" if manager else ""),
            related=[*([note(entry.name, "a lifecycle manager should activate it")] if entry else []), *related],
            severity="info" if not ours and node.state == "inactive" else "error" if ours and settled else "warning",
        )
