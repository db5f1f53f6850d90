"""The netplan version is not 2.

## What it finds
`version:` with another number. A missing version is valid.

## Why it matters on a robot
Netplan supports version 2 only and rejects the whole configuration. Version 1 is cloud-init's own format,
which netplan cannot read.

## Bad
```yaml
network:
  version: 1
```

## Good
```yaml
network:
  version: 2
```

## When to ignore it
Never: `netplan generate` stops here and configures nothing.

## References
- netplan YAML reference, "version"
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import fix
from bringup_lint.api import rule
from bringup_lint.api.schema import Code


@rule("error", fix="unsafe", symptoms=["Only version 2 is supported"])
def version(robot: Robot) -> Iterator[Finding]:
    for problem in robot.netplan.problems(Code.VERSION):
        change = fix("write version 2", (problem.where, "2"))
        yield finding(
            problem.where,
            "Only version 2 is supported: netplan generates nothing",
            advice="write 2",
            fix=change,
        )
