"""Cyclone DDS does not know an element.

## What it finds
An element that no version of the library knows at this place, or one that is in the wrong group. Names are
not case-sensitive, and older names that the library still accepts are not reported. Elements that need a
special build of the library are reported too.

## Why it matters on a robot
The library stops at the first unknown element and creates no participant: no ROS node starts.

## Bad
```xml
<General>
  <Interface name="eth0"/>
</General>
```

## Good
```xml
<General>
  <Interfaces>
    <NetworkInterface name="eth0"/>
  </Interfaces>
</General>
```

## When to ignore it
If the robot uses a fork or a build of your own that knows the element. Otherwise never.

## References
- Cyclone DDS 0.10.5 and 11.0.1, tested with the real library
- https://github.com/eclipse-cyclonedds/cyclonedds/issues/2201
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import fix
from bringup_lint.api import rule
from bringup_lint.api.cyclonedds import can_be_renamed
from bringup_lint.api.cyclonedds import meant_item
from bringup_lint.api.cyclonedds import place_of
from bringup_lint.api.cyclonedds import versions_with
from bringup_lint.api.dds import renamed
from bringup_lint.api.schema import Code


@rule("error", fix="unsafe", symptoms=["unknown element"])
def unknown_element(robot: Robot) -> Iterator[Finding]:
    for configuration, remark in robot.dds.remarks(Code.UNKNOWN, Code.AMBIGUOUS, Code.BUILD):
        if versions_with(remark) and remark.code != Code.BUILD:
            continue
        library = robot.dds.cyclonedds
        message = f"{library} does not know the element '{remark.word}': no participant can be created, no node starts"
        if remark.code == Code.BUILD:
            message = (
                f"'{remark.word}' needs a build with {remark.detail}, which ROS packages do not have: no node starts"
            )
        meant = meant_item(remark)
        place = place_of(configuration, remark)
        advice = "delete it, or look up the name in the configuration guide of this version"
        if meant is not None:
            advice = f"write {meant.name}"
        elif place:
            advice = f"move it into {place}"
        change = None
        if meant is not None and can_be_renamed(configuration, remark.word, meant):
            change = fix(f"rename to {meant.name}", *renamed(remark.word, meant.name), safe=False)
        yield finding(remark.word, message, advice=advice, fix=change)
