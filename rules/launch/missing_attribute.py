"""A tag of an XML or YAML launch file lacks what it needs.

## What it finds
Required attributes and children that are not there: `exec` of a node, `file` of an include, `name` and `value` of a
`<let>`, the value of a `<param>`, the name and namespace of a container.

## Why it matters on a robot
`ros2 launch` stops before it starts a single node. A unit that runs it fails at every boot.

## Bad
```xml
<include url="other.launch.xml"/>
```

## Good
```xml
<include file="$(dirname)/other.launch.xml"/>
```

## When to ignore it
Only for a file that is not launched, such as a template that a generator fills in.

## References
- ros2/launch, `Entity.get_attr`
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import rule
from bringup_lint.api.launch import refused


@rule(
    "error",
    symptoms=[
        "Attribute 'exec' of type",
        "Can not find attribute",
        "param Entity should have name or from attribute",
    ],
)
def missing_attribute(robot: Robot) -> Iterator[Finding]:
    yield from refused(robot.launch, "missing", "add it")
