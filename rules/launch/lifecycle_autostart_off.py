"""A lifecycle manager does not start its nodes.

## What it finds
Lifecycle managers of nav2 whose `autostart` is false or not set (false is the default). If an argument passes the
value, the finding is info.

## Why it matters on a robot
All managed nodes stay unconfigured until somebody calls the manager's service by hand. After a boot without an
operator, nothing navigates.

## Bad
```python
parameters=[{'node_names': ['map_server', 'amcl']}]
```

## Good
```python
parameters=[{'autostart': True, 'node_names': ['map_server', 'amcl']}]
```

## When to ignore it
When an operator or a node outside this tree activates the nodes on purpose, for example after a safety check.

## References
- nav2, lifecycle manager parameters
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import launch
from bringup_lint.api import rule


@rule("warning", fix="none", silent="the lifecycle manager waits for a request without a message")
def lifecycle_autostart_off(robot: Robot) -> Iterator[Finding]:
    for expansion in robot.launch.expansions:
        entry = expansion.entry
        if robot.launch.simulated(entry):
            continue
        for manager in launch.managers(expansion):
            value, known, name = manager.autostart
            if manager.node.file is not entry or not known or launch.transitions_elsewhere(expansion, manager.node):
                continue
            if value is not None and launch.truth(value) is not False:
                continue
            written = (value for name, value in manager.parameters() if name == "autostart")
            passed = any(isinstance(each, launch.Argument) for value in written for each in launch.walk(value))
            yield finding(
                manager.node.span if name is None else name,
                "Autostart is off"
                + (" by default" if passed or value is None else "")
                + ": all managed nodes stay unconfigured until somebody calls the manager",
                advice="set autostart to true",
                severity="info" if passed else None,
            )
