"""A tag of an XML or YAML launch file has an attribute that launch does not know.

## What it finds
Attributes and keys that a tag does not have, misspelt or from another tag, and those that exclude each other. Silent
for the root and for `<choice>`, where launch ignores them.

## Why it matters on a robot
`ros2 launch` stops before it starts a single node. A unit that runs it fails at every boot.

## Bad
```xml
<node pkg="demo" exec="driver" respwn="true"/>
```

## Good
```xml
<node pkg="demo" exec="driver" respawn="true"/>
```

## When to ignore it
When the robot runs a newer distribution than the one that the tree names.

## References
- ros2/launch, `Entity.assert_entity_completely_parsed`
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import rule
from bringup_lint.api.launch import refused


@rule("error", fix="unsafe", symptoms=["Unexpected attribute(s) found in", "Unexpected key(s) found in"])
def unknown_attribute(robot: Robot) -> Iterator[Finding]:
    yield from refused(robot.launch, "attribute", "remove it")
