"""Cyclone DDS does not know an attribute.

## What it finds
An attribute that no version of the library knows for its element. Namespace and schema attributes of the root
element are valid.

## Why it matters on a robot
The library stops at the attribute and creates no participant: no ROS node starts.

## Bad
```xml
<NetworkInterface device="eth0"/>
```

## Good
```xml
<NetworkInterface name="eth0"/>
```

## When to ignore it
If the robot uses a fork or a build of your own that knows the attribute. Otherwise never.

## References
- Cyclone DDS 0.10.5 and 11.0.1, tested with the real library
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import fix
from bringup_lint.api import rule
from bringup_lint.api.cyclonedds import can_be_renamed
from bringup_lint.api.cyclonedds import meant_item
from bringup_lint.api.cyclonedds import versions_with
from bringup_lint.api.schema import Code


@rule("error", fix="unsafe", symptoms=["unknown attribute"])
def unknown_attribute(robot: Robot) -> Iterator[Finding]:
    for configuration, remark in robot.dds.remarks(Code.UNKNOWN_ATTRIBUTE):
        if versions_with(remark):
            continue
        meant = meant_item(remark)
        library = robot.dds.cyclonedds
        is_clear = meant is not None and can_be_renamed(configuration, remark.word, meant)
        yield finding(
            remark.where,
            f"{library} does not know the attribute '{remark.where}': no participant can be created, no node starts",
            advice=f"write {meant.name}" if meant else "delete the attribute",
            fix=fix(f"rename to {meant.name}", (remark.where, meant.name), safe=False) if meant and is_clear else None,
        )
