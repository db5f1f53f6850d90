"""The Id of a Domain is neither any nor a number.

## What it finds
A `Domain` whose `Id` is neither `any` nor an unsigned decimal number below 4294967295.

## Why it matters on a robot
The library reports `neither 'any' nor a less than 2**32-1` and creates no participant: no ROS node starts.

## Bad
```xml
<Domain Id="robot">
```

## Good
```xml
<Domain Id="any">
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
from bringup_lint.api import fix
from bringup_lint.api import rule
from bringup_lint.api.schema import Code


@rule("error", fix="unsafe", symptoms=["neither 'any' nor a less than 2**32-1"])
def domain_id_invalid(robot: Robot) -> Iterator[Finding]:
    for _, remark in robot.dds.remarks(Code.VALUE):
        if remark.known.path == "CycloneDDS/Domain@Id":
            yield finding(
                remark.where,
                f"The domain Id '{remark.where}' is neither 'any' nor a number: no participant can be "
                "created, no node starts",
                advice="write any",
                fix=fix("write any", (remark.where, "any"), safe=False),
            )
