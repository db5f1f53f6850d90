"""A grant has no valid default.

## What it finds
A grant whose `default` is missing, or is not exactly `ALLOW` or `DENY`.

## Why it matters on a robot
Cyclone DDS then denies what no rule allows. Other libraries may reject the document, and the node does not
start.

## Bad
```xml
<default>deny</default>
```

## Good
```xml
<default>DENY</default>
```

## When to ignore it
If every computer of the robot uses Cyclone DDS and the default should be DENY.

## References
- Cyclone DDS 0.10.5 with security, tested with the real library
- OMG DDS Security 1.1, clause 9.4.1.3
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import fix
from bringup_lint.api import rule
from bringup_lint.api.schema import Code


@rule("warning", fix="unsafe", symptoms=["Invalid text indefault tag. Line", "Expected tag default. Line"])
def permissions_default_missing(robot: Robot) -> Iterator[Finding]:
    for permissions in robot.sros2.permissions:
        if not robot.sros2.is_used(permissions.source):
            continue
        for remark in permissions.remarks:
            if remark.code == Code.ENUM and remark.detail == "default":
                text = remark.inside.text
                right = text.upper() if text.upper() in ("ALLOW", "DENY") else "DENY"
                yield finding(
                    remark.where,
                    f"'{text}' is not a valid default: Cyclone DDS denies, other libraries may reject the document",
                    advice=f"write {right}",
                    fix=fix(f"write {right}", (remark.where, right)) if text else None,
                )
            elif remark.code == Code.MISSING and remark.detail == "default":
                yield finding(
                    remark.where,
                    "The grant has no default: Cyclone DDS denies, other libraries may reject the document",
                    advice="end the grant with <default>DENY</default>",
                )
