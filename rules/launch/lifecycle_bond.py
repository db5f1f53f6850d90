"""A lifecycle manager cannot monitor its nodes with a bond.

## What it finds
Three mistakes with the `bond_timeout` of a nav2 lifecycle manager:

- It is 0, so the manager does not monitor its nodes.
- It is above 0, also by default, and a managed node opens no bond: one of a public package outside nav2, or one of the
  tree whose class builds on `rclcpp_lifecycle::LifecycleNode` or that of rclpy, in a package without bonds.
- A comment calls it the time of a transition.

## Why it matters on a robot
Without a bond a dead node goes unnoticed: the rest of navigation continues without its map or its controller. If
the manager waits for a bond that a node does not open, the activation fails after the timeout.

## Bad
```python
parameters=[{'autostart': True, 'bond_timeout': 0.0, 'node_names': ['controller_server']}]
```

## Good
```python
parameters=[{'autostart': True, 'bond_timeout': 4.0, 'node_names': ['controller_server']}]
```

## When to ignore it
When the node opens a bond through a library that is not in the tree, or when you switch the bond off only for
debugging.

## References
- nav2, lifecycle manager parameters; lifecycle_manager.cpp, `createBondConnection`
- nav2_util, lifecycle_node.cpp, `createBond`: the lifecycle node of nav2 opens the bond, that of rclcpp does not
"""

from collections.abc import Iterator
from collections.abc import Sequence

from bringup_lint.api import Finding
from bringup_lint.api import Located
from bringup_lint.api import Robot
from bringup_lint.api import Source
from bringup_lint.api import finding
from bringup_lint.api import launch
from bringup_lint.api import note
from bringup_lint.api import rule
from bringup_lint.api import topics

MOVING = ("controller_server", "behavior_server", "recoveries_server", "velocity_smoother", "docking_server")
"""Servers that drive the robot, or limit how it is driven."""
BONDED = ("nav2_", "opennav_", "slam_toolbox")


@rule(
    "warning",
    symptoms=[
        "was unable to be reached after * by bond. This server may be misconfigured",
        "IS DOWN after not receiving a heartbeat for",
    ],
)
def lifecycle_bond(robot: Robot) -> Iterator[Finding]:
    bonds = topics.Bonds(robot.topics)
    for expansion in robot.launch.entries:
        if robot.launch.simulated(expansion.entry):
            continue
        started = {launch.full_name(node, robot.launch.role(node)): node for node in expansion.nodes}
        for manager in launch.managers(expansion):
            name = manager.bond_timeout.name
            if name is not None and "transition" in _comment_above(name).lower():
                yield finding(
                    name,
                    "bond_timeout does not limit a transition: a node without a heartbeat for this long counts as dead",
                    advice="correct the comment, and keep 4.0 for the nodes of nav2",
                )
            nodes = [(managed, started[managed.fqn]) for managed in manager.managed or () if managed.fqn in started]
            foreign = [
                (managed, node)
                for managed, node in nodes
                if robot.launch.role(node).managed and not str(launch.literal_text(node.package)).startswith(BONDED)
            ]
            if name is not None and manager.watches is False and not foreign and _is_missed(manager, nodes):
                yield finding(
                    name,
                    "bond_timeout is 0: the manager does not notice when a managed node dies",
                    advice="set bond_timeout to 4.0",
                )
            if not manager.watches:
                continue
            for managed, node in foreign:
                yield finding(
                    managed.name,
                    f"{launch.literal_text(node.package)} opens no bond: its activation fails after the bond_timeout",
                    advice="give it a separate manager with bond_timeout 0",
                    related=[note(node.span, "the node is started here")],
                )
        for managed, node, base in bonds.lacking(expansion):
            yield _of_tree(managed.name, node, base)


def _is_missed(manager: launch.Manager, nodes: Sequence[tuple[launch.Managed, launch.Started]]) -> bool:
    """Whether somebody should notice that a node dies: the robot moves by it, or launch starts it again."""
    moving = manager.managed is None or any(each.name.rpartition("/")[2] in MOVING for each in manager.managed)
    return moving or any(launch.respawns(node) for _, node in nodes)


def _of_tree(name: Located, node: launch.Started, base: Located) -> Finding:
    return finding(
        name,
        f"The source of '{name}' opens no bond: the manager aborts the bring-up after the bond_timeout",
        advice="build the class on nav2_util::LifecycleNode, or give it a separate manager with bond_timeout 0",
        related=[note(base, "a plain lifecycle node"), note(node.span, "the node is started here")],
    )


def _comment_above(name: Located) -> str:
    """The comment above a line, past one that silences a rule."""
    source = name.span.source
    lines = ((_said(source, line), source.line_text(line)) for line in range(name.line - 1, 0, -1))
    comment = next((said for said, text in lines if said or not text.strip()), "")
    return comment if comment.startswith("#") else ""


def _said(source: Source, line: int) -> str:
    return source.said[source.line_starts[line - 1] : source.line_starts[line]].strip()
