"""Cyclone DDS cannot parse the XML.

## What it finds
XML that the library's own parser refuses: end tags that do not match, text after the root element, a bare
`&`, an entity. A DOCTYPE that the library skips is a warning: it never expands entities.

## Why it matters on a robot
The library stops at the first error and creates no participant, so no ROS node starts at all.

## Bad
```xml
<General><DontRoute>true</General></DontRoute>
```

## Good
```xml
<General><DontRoute>true</DontRoute></General>
```

## When to ignore it
Never for an error: no node starts. A DOCTYPE is harmless if an editor needs it.

## References
- Cyclone DDS 0.10.5 and 11.0.1, tested with the real library
- https://github.com/iRobotEducation/create3_docs/issues/455
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import rule
from bringup_lint.api.schema import Code


@rule("error", symptoms=["parser error", "open/close tag mismatch", "invalid token encountered"])
def xml_not_wellformed(robot: Robot) -> Iterator[Finding]:
    for _, remark in robot.dds.remarks(Code.XML):
        if not remark.fatal:
            message = "Cyclone DDS skips the DOCTYPE: its declarations have no effect"
            yield finding(remark.where, message, advice="delete the DOCTYPE", severity="warning")
            continue
        why = remark.xml_problem
        message = f"Cyclone DDS cannot parse the file ({why}): no participant can be created, no node starts"
        yield finding(remark.where, message, advice="repair the XML")
