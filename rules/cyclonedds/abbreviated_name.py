"""A shortened Cyclone DDS name.

## What it finds
A name that is only the beginning of the real one, such as `addr` for `Address`. The library takes
unique beginnings only in XML that is given inline in `CYCLONEDDS_URI`.

## Why it matters on a robot
In a file the shortened name is unknown: no participant, no ROS node. Inline it works until another name
begins the same way.

## Bad
```xml
<Peer addr="10.0.0.10"/>
```

## Good
```xml
<Peer Address="10.0.0.10"/>
```

## References
- Cyclone DDS 0.10.5 and 11.0.1, tried with the real library
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import fix
from bringup_lint.api import rule
from bringup_lint.api.schema import Code


@rule("error", fix="safe", symptoms=["unknown element", "unknown attribute", "ambiguous"])
def abbreviated_name(robot: Robot) -> Iterator[Finding]:
    for _, remark in robot.dds.remarks(Code.ABBREVIATED):
        if remark.fatal:
            message = f"'{remark.where}' is no full name, and a file may not shorten names: no node starts"
        else:
            message = f"'{remark.where}' works only as long as no other name begins with it"
        yield finding(
            remark.where,
            message,
            advice=f"write {remark.detail}",
            severity=None if remark.fatal else "info",
            fix=fix(f"write {remark.detail}", *robot.dds.renamed(remark.where, remark.detail)),
        )
