"""Lifecycle nodes are activated in the wrong order.

## What it finds
A lifecycle manager of nav2 that lists `amcl` before `map_server`, or `bt_navigator` before one of the servers that
it calls.

## Why it matters on a robot
The manager configures and activates nodes in the order of the list. A node whose partner is not ready yet waits, or
its activation fails and the manager aborts the whole bring-up.

## Bad
```python
'node_names': ['amcl', 'map_server']
```

## Good
```python
'node_names': ['map_server', 'amcl']
```

## When to ignore it
When your behavior tree never calls the server that is listed later.

## References
- nav2, lifecycle manager
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import fix
from bringup_lint.api import launch
from bringup_lint.api import note
from bringup_lint.api import rule
from bringup_lint.api.python import move_after

BEFORE = {
    "amcl": (("map_server",), "it waits for a map"),
    "bt_navigator": (
        ("planner_server", "controller_server", "behavior_server", "smoother_server"),
        "it looks for action servers that are not there yet",
    ),
}


@rule("warning", fix="unsafe")
def lifecycle_order(robot: Robot) -> Iterator[Finding]:
    for expansion in robot.launch.expansions:
        for manager in launch.managers(expansion):
            managed = manager.managed if manager.node.file is expansion.entry else None
            for index, (name, fqn) in enumerate(managed or ()):
                needed, effect = BEFORE.get(fqn.rpartition("/")[2], ((), ""))
                late = [later.name for later in managed[index + 1 :] if later.fqn.rpartition("/")[2] in needed]
                if late:
                    move = move_after(name.span, late[-1].span)
                    yield finding(
                        name,
                        f"{name} is activated before {late[0]}: {effect}",
                        advice=f"list it after {late[-1]}",
                        fix=fix(f"list it after {late[-1]}", codemod=move, safe=False) if move else None,
                        related=[note(other, "listed later") for other in late],
                    )
