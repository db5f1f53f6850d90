"""Cyclone DDS does not expect text here.

## What it finds
Text inside an element that accepts only attributes or other elements, such as `SocketReceiveBufferSize` or
`General`. `Peer` has its own rule.

## Why it matters on a robot
The library reports `no data expected` and creates no participant: no ROS node starts.

## Bad
```xml
<SocketReceiveBufferSize>10MB</SocketReceiveBufferSize>
```

## Good
```xml
<SocketReceiveBufferSize min="10MB"/>
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


@rule("error", symptoms=["no data expected"])
def unexpected_text(robot: Robot) -> Iterator[Finding]:
    for _, remark in robot.dds.remarks(Code.TEXT):
        if remark.known.name == "Peer":
            continue
        attributes = [item.name for item in remark.known.attributes.values()]
        takes = f"attributes ({', '.join(attributes)})" if attributes else "other elements"
        what = f"accepts {takes}, but no text"
        if remark.known.type != "group":
            what = "cannot have both text and other elements"
        yield finding(
            remark.where,
            f"{remark.known.name} {what}: no participant can be created, no node starts",
            advice=f'write the value as {attributes[0]}="..."' if len(attributes) in (1, 2) else "remove the text",
        )
