"""An XML or YAML launch file has a tag that launch does not know.

## What it finds
A tag that no distribution in question has, a tag at a place where it is not allowed (`<remap>` among the actions,
`<param>` in an `<include>`), and in YAML the same as keys.

## Why it matters on a robot
`ros2 launch` stops before it starts a single node. A unit that runs it fails at every boot.

## Bad
```xml
<launch>
  <nod pkg="demo" exec="driver"/>
</launch>
```

## Good
```xml
<launch>
  <node pkg="demo" exec="driver"/>
</launch>
```

## When to ignore it
When an extension of launch that is not in the tree defines the tag.

## References
- ros2/launch, `launch.frontend.expose.instantiate_action`
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import rule
from bringup_lint.api.launch import refused


@rule(
    "error",
    fix="unsafe",
    symptoms=[
        "Unrecognized entity of the type",
        "Unexpected nested tag(s) found",
        "Unexpected nested entity(ies) found in",
    ],
)
def unknown_tag(robot: Robot) -> Iterator[Finding]:
    yield from refused(robot.launch, "tag", "remove it, or put it where it belongs")
