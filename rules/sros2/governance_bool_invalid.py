"""A boolean in a governance document that is not true or false.

## What it finds
A boolean other than `true`, `false`, `1` or `0`. `TRUE` and the like pass in Cyclone DDS and in newer
builds of Fast DDS, so they are only a warning.

## Why it matters on a robot
A library that cannot read the value rejects the whole document: no node starts. Which one does differs from
vendor to vendor and from version to version.

## Bad
```xml
<enable_join_access_control>yes</enable_join_access_control>
```

## Good
```xml
<enable_join_access_control>true</enable_join_access_control>
```

## References
- Cyclone DDS 0.10.5 with security, tried with the real library
- OMG DDS Security 1.1, clause 9.4.1.2
"""

from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import fix
from bringup_lint.api import rule


@rule("error", fix="safe")
def governance_bool_invalid(robot: Robot):
    for document, remark in robot.sros2.remarks("bool"):
        text = remark.element.text
        right = text.lower() if text.lower() in ("true", "false") else ""
        if right and not robot.sros2.is_used(document.source):
            continue
        yield finding(
            remark.where,
            f"'{text}' is no boolean of the specification: Cyclone DDS takes it, others may reject the document"
            if right
            else f"'{text}' is no boolean for {remark.detail}: the document is rejected, no node starts",
            advice=f"write {right}" if right else "write true or false",
            severity="warning" if right else None,
            fix=fix(f"write {right}", (remark.where, right)) if right else None,
        )
