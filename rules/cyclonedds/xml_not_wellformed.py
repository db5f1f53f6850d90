"""Cyclone DDS cannot parse the XML.

## What it finds
A configuration that the library's own XML reader refuses: end tags that do not match, text after the
root element, a bare `&`, an entity. A DOCTYPE is reported too: entities are never expanded.

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

## References
- Cyclone DDS 0.10.5 and 11.0.1, tried with the real library
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
            message = "Cyclone DDS steps over the DOCTYPE: what it declares has no effect"
            yield finding(remark.where, message, advice="delete the DOCTYPE", severity="warning")
            continue
        problem, _, detail = remark.detail.partition(": ")
        words = problem.replace("-", " ") + (f", {detail}" if detail else "")
        message = f"Cyclone DDS cannot parse the file ({words}): no participant can be created, no node starts"
        yield finding(remark.where, message, advice="repair the XML")
