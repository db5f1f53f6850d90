"""A lifecycle node that calls others is activated before them.

## What it finds
A lifecycle manager of nav2 that lists `bt_navigator` before one of the servers that it calls.

## Why it matters on a robot
The manager configures all nodes, and then activates them in the order of the list. Until the servers are active too,
they reject what `bt_navigator` sends: a goal that arrives in between fails.

## Bad
```python
'node_names': ['bt_navigator', 'planner_server']
```

## Good
```python
'node_names': ['planner_server', 'bt_navigator']
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

CALLED = {"bt_navigator": ("planner_server", "controller_server", "behavior_server", "smoother_server")}


@rule("info", fix="unsafe", symptoms=["Action server is inactive. Rejecting the goal."])
def lifecycle_order(robot: Robot) -> Iterator[Finding]:
    for expansion in robot.launch.expansions:
        for manager in launch.managers(expansion):
            managed = (manager.managed if manager.node.file is expansion.entry else None) or []
            for index, (name, fqn) in enumerate(managed):
                called = CALLED.get(fqn.rpartition("/")[2])
                if called is None:
                    continue
                late = [later.name for later in managed[index + 1 :] if later.fqn.rpartition("/")[2] in called]
                if late:
                    move = move_after(name.span, late[-1].span)
                    yield finding(
                        name,
                        f"{name} is active before {late[0]}: a goal in between is rejected",
                        advice=f"list it after {late[-1]}",
                        fix=fix(f"list it after {late[-1]}", codemod=move, safe=False) if move else None,
                        related=[note(other, "listed later") for other in late],
                    )
