"""The emergency stop is only a topic.

## What it finds
A topic for an emergency stop (`e_stop`, `emergency_stop`, ...) in a tree that shows no sign of stop hardware: no
GPIO library, no safety controller, no PLC. Wiring is not visible in files, so this is a question, not a verdict.

## Why it matters on a robot
A topic fails together with the network, the computer and the node: exactly when it is needed. Standards for mobile
robots require a circuit that cuts the power of the drives without any software.

## Bad
```python
self.create_subscription(Bool, "emergency_stop", self.on_stop, 1)   # and nothing else
```

## Good
```toml
# bringup-lint.toml: the button cuts the drive power, see the wiring plan
ignore = ["node/estop-software-only"]
```

## When to ignore it
When a wired circuit cuts the drive power, as in the example above. Name the wiring plan in the reason.

## References
- ISO 13850, emergency stop function
- ISO 13849-1, safety-related parts of control systems
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import rule
from bringup_lint.api import topics


@rule("info", confidence="medium", silent="a lost stop message leaves no trace")
def estop_software_only(robot: Robot) -> Iterator[Finding]:
    named = ((each.name, each.span) for each in robot.topics.endpoints)
    stops = [(name, where) for name, where in named if name is not None and _is_command(name)]
    if stops and not robot.topics.has_stop_hardware:
        name, where = stops[0]
        yield finding(
            name,
            f"The only visible emergency stop is the topic {name}: it fails together with the network, the "
            "computer or the node",
            advice="let a wired circuit cut the drive power; if there is one, ignore this rule in the configuration",
            related=topics.used_at(name, where),
        )


def _is_command(name: str) -> bool:
    """Whether a topic stops the robot, and does not only report that something else has."""
    return topics.is_stop(name) and not name.endswith(("status", "state", "active", "pressed"))
