"""A lifecycle manager gets a parameter that it does not have.

## What it finds
Misspelt parameter names on a nav2 lifecycle manager.

## Why it matters on a robot
The manager ignores unknown parameters. `auto_start: true` leaves every node unconfigured.

## Bad
```python
parameters=[{'auto_start': True, 'node_names': ['map_server']}]
```

## Good
```python
parameters=[{'autostart': True, 'node_names': ['map_server']}]
```

## When to ignore it
When your fork of the lifecycle manager declares the parameter.

## References
- nav2, lifecycle manager parameters
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import fix
from bringup_lint.api import launch
from bringup_lint.api import rule
from bringup_lint.api.spelling import nearest

KNOWN = (
    "use_sim_time",
    "autostart",
    "node_names",
    "bond_timeout",
    "bond_respawn_max_duration",
    "attempt_respawn_reconnection",
    "service_timeout",
    "bond_heartbeat_period",
    "parallelize_state_transitions",
)


@rule("warning", fix="unsafe", silent="a node ignores parameters that it does not declare without a message")
def lifecycle_unknown_param(robot: Robot) -> Iterator[Finding]:
    for expansion in robot.launch.expansions:
        for manager in launch.managers(expansion):
            if manager.node.file is not expansion.entry:
                continue
            for name, _ in manager.parameters():
                near = nearest(name, KNOWN) if name not in KNOWN else []
                if near:
                    yield finding(
                        name,
                        f"'{name}' is not a parameter of the lifecycle manager: it is ignored",
                        advice=f"write '{near[0]}'",
                        fix=fix(f"write '{near[0]}'", (name, near[0]), safe=False) if name.span.text == name else None,
                    )
