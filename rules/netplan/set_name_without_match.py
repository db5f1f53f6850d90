"""set-name is used without match.

## What it finds
`set-name` on an interface that has no `match`.

## Why it matters on a robot
Netplan stops: it does not know which device it should rename. Nothing is generated.

## Bad
```yaml
lidar0:
  set-name: lidar0
```

## Good
```yaml
lidar0:
  match: {macaddress: "00:11:22:33:44:55"}
  set-name: lidar0
```

## When to ignore it
Never: `netplan generate` stops here and configures nothing.

## References
- netplan YAML reference, "set-name"
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import rule
from bringup_lint.api.netplan import PlanCode
from bringup_lint.api.schema import explained

TEXTS: dict[str, tuple[str, str]] = {
    PlanCode.SET_NAME: (
        "set-name needs match: netplan generates nothing",
        "add match with the MAC address of the device",
    ),
}


@rule("error", symptoms=["'set-name:' requires 'match:' properties"])
def set_name_without_match(robot: Robot) -> Iterator[Finding]:
    yield from explained(robot.netplan.problems(*TEXTS), TEXTS)
