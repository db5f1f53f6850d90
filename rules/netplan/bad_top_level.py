"""A netplan file has a top-level key other than network.

## What it finds
A key beside `network:`, or instead of it, at the top level of a file in a netplan folder.

## Why it matters on a robot
Netplan rejects the file, and with it the whole configuration: nothing is generated.

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

## When to ignore it
If the file is not for netplan although it is in one of its folders. Move it: netplan on the robot will read
it.

## References
- netplan YAML reference, "Top-level configuration structure"
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import fix
from bringup_lint.api import rule
from bringup_lint.api.schema import Code
from bringup_lint.api.spelling import nearest
from bringup_lint.api.yaml import is_free_key


@rule("error", fix="unsafe", symptoms=["Error in network definition: unknown key"])
def bad_top_level(robot: Robot) -> Iterator[Finding]:
    for problem in robot.netplan.remarks(Code.UNKNOWN):
        key = problem.word
        if problem.known.name != "{root}":
            continue
        is_clear = bool(nearest(key, ["network"])) and is_free_key("network", key)
        change = fix("rename to network", (key, "network")) if is_clear else None
        advice = "rename it to network" if change else "only network: is allowed at the top level"
        yield finding(key, f"Unknown top-level key '{key}': netplan generates nothing", advice=advice, fix=change)
