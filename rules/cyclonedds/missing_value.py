"""A Cyclone DDS element has no value for a required part.

## What it finds
An element of a list, or `Security`, without a part that has no default: a `Thread` without `Name`, or
`Security` without `IdentityCertificate`, `IdentityCA` or `PrivateKey`. A `Peer` without an address has its
own rule.

## Why it matters on a robot
The library reports `element missing in configuration` and creates no participant: no ROS node starts.

## Bad
```xml
<Thread>
  <StackSize>1MB</StackSize>
</Thread>
```

## Good
```xml
<Thread Name="recv">
  <StackSize>1MB</StackSize>
</Thread>
```

## When to ignore it
Never: the library refuses the file, and no node starts.

## References
- Cyclone DDS 0.10.5 and 11.0.1, tested with the real library
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import rule
from bringup_lint.api.schema import Code


@rule("error", symptoms=["element missing in configuration"])
def missing_value(robot: Robot) -> Iterator[Finding]:
    for _, remark in robot.dds.remarks(Code.MISSING):
        if remark.known.path.endswith("/Peer@Address"):
            continue
        yield finding(
            remark.where,
            f"{remark.where} has no {remark.detail} (element missing in configuration): no node starts",
            advice=f"add {remark.detail}",
        )
