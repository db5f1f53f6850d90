"""A Fast DDS setting that has no effect.

## What it finds
QoS that the library knows by name and does not support from XML: `durabilityService`, `presentation`,
`timeBasedFilter`, `destinationOrder`, and the tags `qos_profile`, `application` and `type` below
`profiles`.

## Why it matters on a robot
The library logs an error at every start and goes on without the setting.

## Bad
```xml
<presentation>
  <access_scope>TOPIC</access_scope>
</presentation>
```

## Good
```xml
<!-- set it in the program -->
```

## References
- Fast DDS 2.14.5, tried with the real library
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import rule
from bringup_lint.api.schema import Code


@rule("warning", symptoms=["do not supported for now"])
def ignored_setting(robot: Robot) -> Iterator[Finding]:
    for _, remark in robot.dds.fastdds_remarks(Code.IGNORED):
        yield finding(
            remark.where,
            f"{remark.where} is not supported in XML: it has no effect, and every start logs an error",
            advice="delete it",
        )
    for _, remark in robot.dds.fastdds_remarks(Code.PASSED_OVER):
        kind = robot.dds.transport_type(remark.where)
        yield finding(
            remark.where,
            f"A {kind} transport does not read {remark.where}: it has no effect",
            advice="delete it, or choose another type",
        )
