"""An attribute that Cyclone DDS does not know.

## What it finds
An attribute that no version of the library knows for its element. Namespace and schema attributes on
the root are fine.

## Why it matters on a robot
The library stops there and creates no participant: no ROS node starts.

## Bad
```xml
<NetworkInterface device="eth0"/>
```

## Good
```xml
<NetworkInterface name="eth0"/>
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


@rule("error", fix="unsafe", symptoms=["unknown attribute"])
def unknown_attribute(robot: Robot) -> Iterator[Finding]:
    for configuration, remark in robot.dds.remarks(Code.UNKNOWN_ATTRIBUTE):
        if robot.dds.accepted_by(configuration, remark):
            continue
        meant = robot.dds.spelling(configuration, remark)
        library = robot.dds.cyclonedds
        yield finding(
            remark.where,
            f"'{remark.where}' is an unknown attribute for {library}: no participant can be created, no node starts",
            advice=f"write {meant.name}" if meant else "delete the attribute",
            fix=fix(f"rename to {meant.name}", (remark.where, meant.name), safe=False) if meant else None,
        )
