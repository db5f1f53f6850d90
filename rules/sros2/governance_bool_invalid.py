"""A boolean in a governance document is neither true nor false.

## What it finds
A boolean other than `true`, `false`, `1` or `0`. Cyclone DDS and newer builds of Fast DDS accept `TRUE` and
similar spellings, which are therefore only a warning.

## Why it matters on a robot
A library that cannot read the value rejects the whole document: no node starts. Which libraries accept a
spelling differs between vendors and versions.

## Bad
```xml
<enable_join_access_control>yes</enable_join_access_control>
```

## Good
```xml
<enable_join_access_control>true</enable_join_access_control>
```

## When to ignore it
Only for the warning: if all computers of the robot run a middleware that accepts the spelling, and will keep
doing so.

## References
- Cyclone DDS 0.10.5 with security, tested with the real library
- OMG DDS Security 1.1, clause 9.4.1.2
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import fix
from bringup_lint.api import rule
from bringup_lint.api.schema import Code


@rule("error", fix="safe", symptoms=["Expected boolean value in * tag. Line"])
def governance_bool_invalid(robot: Robot) -> Iterator[Finding]:
    for document, remark in robot.sros2.remarks(Code.BOOL):
        text = remark.inside.text
        right = text.lower() if text.lower() in ("true", "false") else ""
        if right and not robot.sros2.is_used(document.source):
            continue
        yield finding(
            remark.where,
            f"'{text}' is not a boolean of the specification: Cyclone DDS accepts it, others may reject the document"
            if right
            else f"'{text}' is not a valid {remark.detail}: the document is rejected, no node starts",
            advice=f"write {right}" if right else "write true or false",
            severity="warning" if right else None,
            fix=fix(f"write {right}", (remark.where, right)) if right else None,
        )
