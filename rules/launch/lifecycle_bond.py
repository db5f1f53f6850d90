"""A lifecycle manager does not notice that a node dies, or waits for a bond that never comes.

## What it finds
`bond_timeout: 0` on a lifecycle manager of nav2, managed nodes of other packages that open no bond while
`bond_timeout` is above 0, and comments that take it for the time of a transition.

## Why it matters on a robot
Without a bond a dead node goes unnoticed: the rest of navigation drives on without its map or its controller. With a
bond that a node does not open, the activation fails after the timeout.

## Bad
```python
parameters=[{'autostart': True, 'bond_timeout': 0.0, 'node_names': ['controller_server']}]
```

## Good
```python
parameters=[{'autostart': True, 'bond_timeout': 4.0, 'node_names': ['controller_server']}]
```

## References
- nav2, lifecycle manager parameters
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import launch
from bringup_lint.api import note
from bringup_lint.api import rule

BONDED = ("nav2_", "opennav_", "slam_toolbox")


@rule("warning")
def lifecycle_bond(robot: Robot) -> Iterator[Finding]:
    for expansion in robot.launch.entries:
        if robot.launch.simulated(expansion.entry):
            continue
        started = {launch.full_name(node, robot.launch.role(node)): node for node in expansion.nodes}
        for manager in launch.managers(expansion):
            name = manager.bond_timeout.name
            comment = name.span.source.line_text(max(name.line - 1, 1)).strip() if name is not None else ""
            if comment.startswith("#") and "transition" in comment.lower():
                yield finding(
                    name,
                    "bond_timeout is no time for a transition: after this silence a node counts as dead",
                    advice="correct the comment, and keep 4.0 for nodes of nav2",
                )
            nodes = [(managed, started[managed.fqn]) for managed in manager.managed or () if managed.fqn in started]
            foreign = [
                (managed, node)
                for managed, node in nodes
                if robot.launch.role(node).managed and not str(launch.literal_text(node.package)).startswith(BONDED)
            ]
            if manager.watches is False and not foreign:
                yield finding(
                    manager.bond_timeout.name,
                    "bond_timeout is 0: a managed node that dies is not noticed",
                    advice="set bond_timeout to 4.0",
                )
            for managed, node in foreign if manager.watches else ():
                yield finding(
                    managed.name,
                    f"{launch.literal_text(node.package)} opens no bond: its activation fails after the bond_timeout",
                    advice="put it under a manager of its own with bond_timeout 0",
                    related=[note(node.span, "the node is started here")],
                )
