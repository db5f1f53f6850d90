"""Fast DDS does not expect an element.

## What it finds
An element that the target version does not accept at this place:
- **error**: it is misspelled, in the wrong case, in the wrong parent, or of another version.
- **info**: it is of another version, and the tree does not show the ROS distribution.

## Why it matters on a robot
The library ignores the whole file and uses its defaults: multicast discovery, no peers, no limits. The exit
status is 0, and only a line on the terminal reports the error.

## Bad
```xml
<rtps>
  <initialPeersList/>
</rtps>
```

## Good
```xml
<rtps>
  <builtin>
    <initialPeersList>...</initialPeersList>
  </builtin>
</rtps>
```

## When to ignore it
If the robot has another version of Fast DDS than its distribution, and that version accepts the element.

## References
- Fast DDS 2.14.5, tested with the real library
- XMLElementParser.cpp of 2.6, 2.14, 3.2 and 3.6
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import fix
from bringup_lint.api import rule
from bringup_lint.api.dds import renamed
from bringup_lint.api.fastdds import can_be_renamed
from bringup_lint.api.fastdds import is_beside
from bringup_lint.api.fastdds import meant_name
from bringup_lint.api.fastdds import place_of
from bringup_lint.api.fastdds import versions_with
from bringup_lint.api.schema import Code


@rule("error", fix="unsafe", symptoms=["Invalid element found into", "Found incorrect tag", "Not expected tag"])
def unknown_element(robot: Robot) -> Iterator[Finding]:
    for profiles, remark in robot.dds.fastdds_remarks(Code.UNKNOWN, Code.UNKNOWN_ATTRIBUTE):
        library = robot.dds.fastdds
        name = remark.word
        near = meant_name(profiles, remark)
        others = versions_with(remark)
        place = place_of(profiles, remark)
        parent = remark.path.rpartition("/")[2]
        message = f"'{name}' is not allowed in {parent}: the whole file is ignored, the robot runs with defaults"
        advice = "delete it"
        severity = None
        if others:
            message = (
                f"{library} does not accept '{name}' in {parent} (accepted by {', '.join(others)}): the whole "
                "file is ignored"
            )
            severity = None if library.known else "info"
            advice = f"use an element that {library.version} supports, or set target-ros"
        elif near:
            advice = f"move what it holds into {near}" if is_beside(profiles, name, near) else f"write {near}"
        elif place:
            advice = f"move it into {place}"
        change = None
        if near and not others and can_be_renamed(profiles, remark, near):
            change = fix(f"rename to {near}", *renamed(name, near))
        yield finding(name, message, advice=advice, severity=severity, fix=change)
