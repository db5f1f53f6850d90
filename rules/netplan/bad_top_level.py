"""A netplan file has a top key other than network.

## What it finds
A key beside or instead of `network:` at the top of a file in a netplan folder.

## Why it matters on a robot
Netplan refuses the file, and with it the whole configuration: nothing is generated.

## Bad
```yaml
netwrok:
  version: 2
```

## Good
```yaml
network:
  version: 2
```

## References
- netplan YAML reference, "Top-level configuration structure"
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import fix
from bringup_lint.api import rule
from bringup_lint.api.spelling import nearest


@rule("error", fix="safe", symptoms=["Error in network definition: unknown key"])
def bad_top_level(robot: Robot) -> Iterator[Finding]:
    for problem in robot.netplan.problems("unknown-key"):
        key = problem.where
        if problem.detail != "root":
            continue
        change = fix("rename to network", (key, "network")) if nearest(key, ["network"]) else None
        advice = "rename it to network" if change else "only network: may stand at the top"
        yield finding(key, f"Unknown key '{key}' at the top: netplan generates nothing", advice=advice, fix=change)
